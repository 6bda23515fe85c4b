// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "processes.h"
#include "study.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

namespace program {

namespace {

// Empty if the system does not provide it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      const std::size_t value = line.find(": ");
      if (value != std::string::npos) return line.substr(value + 2);
    }
  return "";
}

// Names the machine, as far as times depend on it: processor, how many of them, system.
std::string machine() {
  utsname system{};
  uname(&system);
  const std::string name = processor();
  return (name.empty() ? system.machine : name) + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " processors, " + system.sysname +
         ' ' + system.release;
}

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno) +
                           "; run fewer jobs at a time (--jobs)");
}

// Shortest digits that are read back as the same number.
std::string digits(double x) { return Json(x).dump(); }

// A process at work, and what it has said so far. Ended with the object.
class Process {
public:
  Process(const Study_job& job, const Study_limits& limits) : job_(job), limits_(limits) {
    const std::array<std::string, 7> words{"intrinsic-study",
                                           "--job",
                                           "--source=" + job.source.location,
                                           "--domain=" + job.source.domain,
                                           "--arithmetic=" + job.arithmetic,
                                           "--time-limit=" + digits(limits.seconds),
                                           "--memory-limit=" + std::to_string(limits.mib)};
    std::array<char*, 8> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i)
      arguments[i] = const_cast<char*>(words[i].c_str()); // execv() does not change them
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("a job cannot be started");
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ == 0) become_job(parent, ends[1], arguments.data());
    close(ends[1]);
    pipe_ = ends[0];
    if (pid_ < 0) {
      close(pipe_);
      fail("a job cannot be started");
    }
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(limits.seconds));
  }
  ~Process() {
    close(pipe_);
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  int pipe() const { return pipe_; }
  Clock::time_point deadline() const { return deadline_; }

  /// reads what there is. \return whether there may be more
  bool read_some() {
    std::array<char, 4096> buffer{};
    const ssize_t n = read(pipe_, buffer.data(), buffer.size());
    if (n < 0) return errno == EINTR;
    text_.append(buffer.data(), static_cast<std::size_t>(n));
    return n > 0;
  }

  /// ends the process, whose time is up.
  void end() {
    is_late_ = true;
    deadline_ = Clock::time_point::max();
    kill(pid_, SIGKILL);
  }

  /// returns the result of the process. \pre `read_some()` returned false
  Json result() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
    Json findings = last_line();
    const auto [outcome, message] = outcome_of(status);
    if (!outcome.empty()) {
      // what the arithmetic did alone stands, whatever became of the comparison
      if (findings.contains("status")) {
        if (!findings.contains("comparison")) findings["comparison"] = outcome;
      } else {
        findings["status"] = outcome;
        findings["message"] = message;
      }
    }
    findings["limits"] = {{"seconds", limits_.seconds}, {"mib", limits_.mib}};
    findings["version"] = INTRINSIC_TRIANGULATIONS_VERSION;
    findings["machine"] = machine();
    return findings;
  }

private:
  [[noreturn]] static void become_job(pid_t parent, int pipe, char* const* arguments) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    dup2(pipe, STDOUT_FILENO);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDERR_FILENO);
    execv("/proc/self/exe", arguments);
    _exit(127);
  }

  // the last line that is complete; only names if there is none
  Json last_line() const {
    const std::size_t end = text_.rfind('\n');
    if (end != std::string::npos) {
      const std::size_t before = end == 0 ? std::string::npos : text_.rfind('\n', end - 1);
      const std::size_t begin = before == std::string::npos ? 0 : before + 1;
      Json line = Json::parse(text_.substr(begin, end - begin), nullptr, false);
      if (line.is_object()) return line;
    }
    return {{"mesh", job_.source.name},
            {"family", job_.source.family},
            {"arithmetic", job_.arithmetic}};
  }

  // empty if the process ended as it should
  std::pair<std::string, std::string> outcome_of(int status) const {
    const bool is_signal = WIFSIGNALED(status);
    if (is_late_ || (is_signal && WTERMSIG(status) == SIGXCPU))
      return {"timed_out",
              (std::ostringstream() << "no result after " << limits_.seconds << " s").str()};
    if (is_signal) {
      const char* const name = sigabbrev_np(WTERMSIG(status));
      return {"crashed", name == nullptr ? "unknown signal" : "SIG" + std::string(name)};
    }
    const int code = WEXITSTATUS(status);
    if (code == exit_out_of_memory)
      return {"out_of_memory", "more than " + std::to_string(limits_.mib) + " MiB"};
    if (code != 0) return {"crashed", "exit code " + std::to_string(code)};
    return {};
  }

  const Study_job& job_;
  const Study_limits& limits_;
  pid_t pid_ = 0;
  int pipe_ = -1;
  Clock::time_point deadline_;
  std::string text_;
  bool is_late_ = false;
};

// waits until a process says something, ends, or must be ended
void wait_for_any(std::list<Process>& running, const std::function<void(const Json&)>& finished) {
  std::vector<pollfd> pipes;
  auto deadline = Clock::time_point::max();
  for (const Process& p : running) {
    pipes.push_back({p.pipe(), POLLIN, 0});
    deadline = std::min(deadline, p.deadline());
  }
  int timeout = -1;
  if (deadline != Clock::time_point::max()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    timeout = static_cast<int>(std::clamp<std::int64_t>(left, 0, 1000000000));
  }
  if (poll(pipes.data(), pipes.size(), timeout) < 0 && errno != EINTR) fail("jobs are lost");
  std::size_t i = 0;
  for (auto p = running.begin(); p != running.end(); ++i) {
    if (p->deadline() <= Clock::now()) p->end();
    if ((pipes[i].revents & (POLLIN | POLLHUP | POLLERR)) != 0 && !p->read_some()) {
      finished(p->result());
      p = running.erase(p);
    } else
      ++p;
  }
}

} // namespace

void run_study_jobs(const std::vector<Study_job>& jobs, unsigned parallel,
                    const Study_limits& limits, const std::function<void(const Json&)>& finished) {
  std::list<Process> running;
  std::size_t next = 0;
  while (next < jobs.size() || !running.empty()) {
    while (next < jobs.size() && running.size() < parallel)
      running.emplace_back(jobs[next++], limits);
    wait_for_any(running, finished);
  }
}

} // namespace program
