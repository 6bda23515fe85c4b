// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search box of the manual, in place of doxygen's, which would ask a server: finds words in the titles and texts of all
// pages and names (text_index.js, see make_text_index.py). Results show while one types; search.html shows all of them.

"use strict";

const KIND_WEIGHT = { manual: 1.5, Python: 1.4, topic: 1.3, class: 1.2, concept: 1.2, function: 1.1, example: 0.7, header: 0.6, enumvalue: 0.6,
  variable: 0.5, friend: 0.4, typedef: 0.6 };
const FOUND_BY = 1e6; // more than any sum of the other weights
const MOST_SHOWN = 200, MOST_SUGGESTED = 12;

function wordsOf(text) {
  return text.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(word => word !== "");
}

// Places in a text at which a word begins as the given one does: `loop` finds `loops` and `add_loop`, not `slooped`.
function occurrences(text, word) {
  const places = [];
  for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
    if (at === 0 || !/[\p{L}\p{N}]/u.test(text[at - 1])) places.push(at);
  return places;
}

// How well an entry [kind, title, address, text, found by] answers the words; 0 if one of them is missing.
function score(entry, words) {
  const phrase = words.join(" ");
  if (entry[4].includes(phrase)) return FOUND_BY; // what the page says itself
  if (phrase.length > 3 && entry[4].some(words => words.startsWith(phrase))) return FOUND_BY / 2; // while one types
  // The name of its class is a word of the text of a member, and the title of its page a word of the text of a section.
  const title = entry[1].toLowerCase().replace(/^.*(::|: )/, ""), text = (entry[3] + " " + entry[1]).toLowerCase();
  const titleWords = wordsOf(title);
  let sum = 0;
  for (const word of words) {
    const inText = occurrences(text, word).length;
    let best = inText > 0 ? 4 + Math.min(inText, 6) : 0;
    if (occurrences(title, word).length > 0) best += 20;
    if (titleWords.includes(word)) best += 20;
    if (best === 0) return 0;
    sum += best;
  }
  if (title.replace("()", "") === words.join("_")) sum += 60;
  if (words.length > 1 && (title.includes(phrase) || text.includes(phrase))) sum += 30;
  return sum * (KIND_WEIGHT[entry[0]] ?? 1) * (entry[1].includes("::") ? 0.8 : 1);
}

// The entries that have all words of a query, the best first.
function findTexts(index, query) {
  const words = wordsOf(query);
  if (words.length === 0) return [];
  return index.map(entry => [score(entry, words), entry]).filter(found => found[0] > 0)
    .sort((a, b) => b[0] - a[0]).map(found => found[1]);
}

// The part of a text around the first of the words that it has.
function excerpt(text, query) {
  const lower = text.toLowerCase();
  const places = wordsOf(query).flatMap(word => occurrences(lower, word).slice(0, 1));
  const from = Math.max(0, Math.min(...places, text.length) - 80);
  const begin = places.length === 0 || from === 0 ? 0 : text.indexOf(" ", from) + 1;
  const end = text.length <= begin + 240 ? text.length : text.lastIndexOf(" ", begin + 240);
  return (begin > 0 ? "… " : "") + text.slice(begin, end) + (end < text.length ? " …" : "");
}

// ---- The page

function resultItem(entry, query, withText) {
  const item = document.createElement("div"), link = document.createElement("a"), kind = document.createElement("span");
  item.className = "found";
  link.href = entry[2];
  link.textContent = entry[1];
  kind.textContent = " " + entry[0];
  item.append(link, kind);
  if (withText) {
    const text = document.createElement("p");
    text.textContent = excerpt(entry[3], query);
    item.append(text);
  }
  return item;
}

function showAll(list, query) {
  const found = findTexts(textIndex, query);
  const count = document.createElement("p");
  count.textContent = found.length === 0 ? `Nothing has all words of “${query}”. Try fewer words, or the beginning of one.`
    : `${found.length} places for “${query}”` + (found.length > MOST_SHOWN ? `, of which ${MOST_SHOWN} are shown.` : ".");
  list.replaceChildren(count, ...found.slice(0, MOST_SHOWN).map(entry => resultItem(entry, query, true)));
}

function suggest(list, query) {
  const found = findTexts(textIndex, query), items = found.slice(0, MOST_SUGGESTED).map(entry => resultItem(entry, query, false));
  if (found.length > 0)
    items.push(resultItem(["in all texts", `All ${found.length} places`, "search.html?query=" + encodeURIComponent(query), ""], query, false));
  list.replaceChildren(...items);
  list.style.display = items.length > 0 ? "block" : "none";
}

function withIndex(action) {
  if (typeof textIndex !== "undefined") return action();
  let script = document.getElementById("text_index");
  if (!script) {
    script = document.createElement("script");
    script.id = "text_index";
    script.src = "text_index.js";
    document.head.append(script);
  }
  script.addEventListener("load", action, { once: true });
}

function startSearch() {
  const field = document.getElementById("MSearchField"), box = document.getElementById("MSearchBox");
  const all = document.getElementById("searchresults");
  if (!field || !box) return setTimeout(startSearch, 20); // a script of doxygen's makes them
  field.value = "";
  field.placeholder = "Search";
  field.autocomplete = "off";
  const list = all ?? document.createElement("div");
  const update = () => withIndex(() => all ? showAll(list, field.value) : suggest(list, field.value));
  if (all) {
    field.value = new URLSearchParams(location.search).get("query") ?? "";
    update();
  } else {
    list.id = "suggestions";
    box.append(list);
    document.addEventListener("click", event => { if (!box.contains(event.target)) list.style.display = "none"; });
    document.addEventListener("keydown", event => { if (event.key === "Escape") list.style.display = "none"; });
  }
  field.addEventListener("input", update);
}

// What the pages call that doxygen generates.
function SearchBox() {
  this.DOMSearchField = () => document.getElementById("MSearchField");
  this.OnSearchFieldFocus = () => {};
}

if (typeof document !== "undefined") window.addEventListener("load", startSearch);
else module.exports = { findTexts };
