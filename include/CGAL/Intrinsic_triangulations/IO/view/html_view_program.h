// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PROGRAM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PROGRAM_H

#include <string_view>

/*!
\file
The program in the page that `write_html_view()` writes: it draws, and answers to the pointer.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// The end of the page, after three.js and the data.
inline constexpr std::string_view html_view_program = R"page(<script>
"use strict";
(function () {
const element = id => document.getElementById(id);
function fail(text) {
  element("failure").textContent = text;
  element("failure").style.display = "block";
}
function decode(id, Type) {
  const text = atob(element(id).textContent), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  element(id).textContent = ""; // it is not needed twice
  return new Type(bytes.buffer);
}
let renderer;
try {
  renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
} catch (error) {
  fail("This page needs WebGL, which this browser does not offer.");
  return;
}
renderer.setPixelRatio(window.devicePixelRatio);
document.body.appendChild(renderer.domElement);

const point = decode("points", Float32Array), triangle = decode("triangles", Uint32Array);
const color = decode("colors", Uint8Array), source = decode("sources", Uint32Array);
const kind = decode("kinds", Uint8Array), label = decode("labels", Uint32Array);
const scalarRange = element("scalars").dataset, scalar = decode("scalars", Float32Array);
const count = triangle.length / 3;

// ---- Faces: three corners of their own, with a normal, a colour and a number to be picked by ----
const position = new Float32Array(9 * count), normal = new Float32Array(9 * count);
const plain = new Uint8Array(9 * count), pick = new Uint8Array(9 * count);
for (let t = 0; t < count; ++t)
  for (let k = 0; k < 3; ++k)
    for (let c = 0; c < 3; ++c) {
      position[9 * t + 3 * k + c] = point[3 * triangle[3 * t + k] + c];
      plain[9 * t + 3 * k + c] = color[3 * t + c];
      pick[9 * t + 3 * k + c] = ((t + 1) >> (8 * c)) & 255;
    }
// An input face is flat: slivers that it was cut into take the normal of the whole.
let faceCount = 0;
for (let t = 0; t < count; ++t) faceCount = Math.max(faceCount, source[2 * t + 1] + 1);
const areaVector = new Float64Array(3 * faceCount);
for (let t = 0; t < count; ++t) {
  const p = position.subarray(9 * t, 9 * t + 9), f = 3 * source[2 * t + 1];
  const u = [p[3] - p[0], p[4] - p[1], p[5] - p[2]], v = [p[6] - p[0], p[7] - p[1], p[8] - p[2]];
  areaVector[f] += u[1] * v[2] - u[2] * v[1];
  areaVector[f + 1] += u[2] * v[0] - u[0] * v[2];
  areaVector[f + 2] += u[0] * v[1] - u[1] * v[0];
}
for (let t = 0; t < count; ++t) {
  const n = areaVector.subarray(3 * source[2 * t + 1], 3 * source[2 * t + 1] + 3);
  const length = Math.hypot(n[0], n[1], n[2]) || 1;
  for (let k = 0; k < 9; ++k) normal[9 * t + k] = n[k % 3] / length;
}
// viridis (S. van der Walt, N. Smith), at nine places
const map = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141],
  [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];
function mapped(x) {
  const y = Math.min(Math.max(x, 0), 1) * 8, i = Math.min(Math.floor(y), 7), f = y - i;
  return [0, 1, 2].map(c => Math.round(map[i][c] * (1 - f) + map[i + 1][c] * f));
}
// Values are between 0 and 1; the range is known in double precision.
const least = Number(scalarRange.least), greatest = Number(scalarRange.greatest);
let field = null;
if (scalar.length > 0) {
  field = new Uint8Array(9 * count);
  for (let i = 0; i < 3 * count; ++i) {
    const x = scalar[triangle[i]];
    field.set(isFinite(x) ? mapped(x) : [128, 128, 128], 3 * i);
  }
  element("scalar-label").style.display = "block";
  element("scalar-name").textContent = scalarRange.name;
  const strip = document.querySelector("#legend canvas").getContext("2d");
  for (let i = 0; i < 256; ++i) {
    strip.fillStyle = "rgb(" + mapped(i / 255).join() + ")";
    strip.fillRect(i, 0, 1, 1);
  }
  element("least").textContent = least.toPrecision(6);
  element("greatest").textContent = greatest.toPrecision(6);
}
function attribute(array, normalized) { return new THREE.BufferAttribute(array, 3, normalized); }
const geometry = new THREE.BufferGeometry();
geometry.setAttribute("position", attribute(position));
geometry.setAttribute("normal", attribute(normal));
geometry.setAttribute("color", attribute(field || plain, true));
geometry.setAttribute("pick", attribute(pick, true));
const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  side: THREE.DoubleSide };
// The eye carries the light: what faces it is bright.
const shaded = new THREE.ShaderMaterial(Object.assign({ vertexShader: `
  attribute vec3 color; varying vec3 c; varying vec3 n; varying vec3 e;
  void main() { c = color; n = normalMatrix * normal; vec4 p = modelViewMatrix * vec4(position, 1.0);
    e = p.xyz; gl_Position = projectionMatrix * p; }`, fragmentShader: `
  varying vec3 c; varying vec3 n; varying vec3 e;
  void main() { float d = length(n) > 0.0 ? abs(dot(normalize(n), normalize(e))) : 1.0;
    gl_FragColor = vec4(c * (0.4 + 0.52 * d), 1.0); }` }, offset));
const picked = new THREE.ShaderMaterial(Object.assign({ vertexShader: `
  attribute vec3 pick; varying vec3 c;
  void main() { c = pick; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
  fragmentShader: `varying vec3 c; void main() { gl_FragColor = vec4(c, 1.0); }` }, offset));
const faces = new THREE.Mesh(geometry, shaded);
const scene = new THREE.Scene(), pickScene = new THREE.Scene();
scene.background = new THREE.Color(0xf4f5f7);
scene.add(faces);
pickScene.add(new THREE.Mesh(geometry, picked));

// ---- Edges: each a rectangle on the screen, narrower where its faces are narrow ----
const size = new THREE.Vector2(1, 1), pixelsPerUnit = { value: 1 };
function edges(id, width, rgb, order) {
  const ends = decode(id, Uint32Array), room = decode(id + "-room", Float32Array);
  const n = room.length, start = new Float32Array(3 * n), end = new Float32Array(3 * n);
  for (let s = 0; s < n; ++s)
    for (let c = 0; c < 3; ++c) {
      start[3 * s + c] = point[3 * ends[2 * s] + c];
      end[3 * s + c] = point[3 * ends[2 * s + 1] + c];
    }
  const g = new THREE.InstancedBufferGeometry();
  g.setAttribute("position", attribute(new Float32Array([0, -1, 0, 0, 1, 0, 1, -1, 0, 1, 1, 0])));
  g.setIndex([0, 1, 2, 2, 1, 3]);
  g.setAttribute("start", new THREE.InstancedBufferAttribute(start, 3));
  g.setAttribute("end", new THREE.InstancedBufferAttribute(end, 3));
  g.setAttribute("room", new THREE.InstancedBufferAttribute(room, 1));
  g.maxInstancedCount = n;
  const material = new THREE.ShaderMaterial({ side: THREE.DoubleSide, transparent: true,
    depthWrite: false, uniforms: { size: { value: size }, width: { value: width },
      rgb: { value: new THREE.Color(rgb) }, pixelsPerUnit: pixelsPerUnit }, vertexShader: `
    attribute vec3 start; attribute vec3 end; attribute float room;
    uniform vec2 size; uniform float width; uniform float pixelsPerUnit; varying float cover;
    void main() {
      vec4 a = modelViewMatrix * vec4(start, 1.0), b = modelViewMatrix * vec4(end, 1.0);
      // cut what is behind the eye, where nothing can be projected
      float near = -0.0005;
      if (a.z > near && b.z < near) a = mix(b, a, (b.z - near) / (b.z - a.z));
      if (b.z > near && a.z < near) b = mix(a, b, (a.z - near) / (a.z - b.z));
      vec4 e = position.x < 0.5 ? a : b;
      float w = clamp(0.2 * room * pixelsPerUnit / max(-e.z, 0.0005), 0.15 * width, width);
      cover = min(w, 1.0); // what is narrower than a pixel is a pixel that is half transparent
      w = max(w, 1.0);
      a = projectionMatrix * a; b = projectionMatrix * b;
      vec2 d = (b.xy / b.w - a.xy / a.w) * size;
      d = length(d) > 1e-6 ? normalize(d) : vec2(1.0, 0.0);
      // nearer to the eye than the faces
      vec4 p = projectionMatrix * vec4(e.xyz * 0.9996, 1.0);
      p.xy += vec2(-d.y, d.x) * position.y * w / size * p.w;
      gl_Position = p;
    }`, fragmentShader: `uniform vec3 rgb; varying float cover;
    void main() { gl_FragColor = vec4(rgb, cover); }` });
  const mesh = new THREE.Mesh(g, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  scene.add(mesh);
  return mesh;
}
const white = new THREE.Color(0xffffff), grey = new THREE.Color(0x7b8594);
const layers = { faces: faces, input: edges("input-edges", 0.9, 0xffffff, 1),
  intrinsic: edges("intrinsic-edges", 1.7, 0x10151d, 2) };

// ---- The camera: points are scaled to the unit ball ----
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
const controls = new THREE.TrackballControls(camera, renderer.domElement);
controls.rotateSpeed = 3;
controls.staticMoving = true;
const up = decode("view-axes", Float32Array);
function reset() {
  controls.reset();
  controls.target.set(0, 0, 0);
  camera.position.set(up[0], up[1], up[2]).multiplyScalar(2.95);
  camera.up.set(up[3], up[4], up[5]);
  camera.lookAt(0, 0, 0);
  controls.update();
  draw();
}
// The clipping planes follow the unit ball, so that depths are precise.
function clip() {
  const distance = camera.position.length();
  camera.near = Math.max(distance - 1.05, 0.002);
  camera.far = distance + 1.05;
  camera.updateProjectionMatrix();
  pixelsPerUnit.value = size.y / (2 * Math.tan(camera.fov * Math.PI / 360));
}
function draw() {
  clip();
  renderer.render(scene, camera);
}
// In a wide window the model is in the middle of what the panel leaves free.
let shift = 0;
function look() { camera.setViewOffset(size.x, size.y, -shift, 0, size.x, size.y); }
function resize() {
  const w = window.innerWidth, h = window.innerHeight, panel = element("panel").offsetWidth;
  renderer.setSize(w, h);
  size.set(w, h);
  shift = w > 2.5 * panel ? panel / 2 : 0;
  const free = w - 2 * shift;
  camera.aspect = w / h;
  camera.fov = free < h ? 2 * Math.atan(Math.tan(Math.PI / 9) * h / free) * 180 / Math.PI : 40;
  look();
  controls.handleResize();
  draw();
}

// ---- What is under the pointer: numbers of triangles are drawn to one pixel ----
const target = new THREE.WebGLRenderTarget(1, 1), pixel = new Uint8Array(4);
function numberAt(x, y) {
  camera.setViewOffset(size.x, size.y, x - shift, y, 1, 1);
  const background = renderer.getClearColor().clone();
  renderer.setRenderTarget(target);
  renderer.setClearColor(0);
  renderer.clear();
  renderer.render(pickScene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
  renderer.setRenderTarget(null);
  renderer.setClearColor(background);
  look();
  return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
}
const corner = new THREE.Vector3();
function distance(v, x, y) {
  corner.fromArray(point, 3 * v).project(camera);
  return Math.hypot((corner.x + 1) / 2 * size.x - x, (1 - corner.y) / 2 * size.y - y);
}
// Triangles of one polygon are a fan, one after the other.
function nearestVertex(t, x, y) {
  const is = s => s >= 0 && s < count && triangle[3 * s] === triangle[3 * t] &&
    source[2 * s] === source[2 * t] && source[2 * s + 1] === source[2 * t + 1];
  let first = t, last = t;
  while (is(first - 1)) --first;
  while (is(last + 1)) ++last;
  let best = triangle[3 * t];
  for (let i = 3 * first; i < 3 * last + 3; ++i)
    if (distance(triangle[i], x, y) < distance(best, x, y)) best = triangle[i];
  return best;
}
function description(v) {
  const a = label[2 * v], b = label[2 * v + 1];
  if (kind[v] === 0) return "input vertex " + b + " (intrinsic " + a + ")";
  if (kind[v] === 1) return "inserted vertex " + a + " in input face " + b;
  return "crossing of intrinsic edge " + a + ", input edge " + b;
}
let pointer = null;
function hover() {
  if (!pointer) return;
  const [x, y] = pointer, t = numberAt(x, y), box = element("hover");
  pointer = null;
  box.style.display = t >= 0 && t < count ? "block" : "none";
  if (t < 0 || t >= count) return;
  const v = nearestVertex(t, x, y);
  let text = "intrinsic face " + source[2 * t] + "\ninput face " + source[2 * t + 1] +
    "\nnearest: " + description(v);
  if (field) text += "\n" + scalarRange.name + " there: " +
    (least * (1 - scalar[v]) + greatest * scalar[v]).toPrecision(6);
  box.textContent = text;
}
renderer.domElement.addEventListener("mousemove", event => {
  if (event.buttons === 0) pointer = [event.clientX, event.clientY];
});
renderer.domElement.addEventListener("mouseleave", () => { element("hover").style.display = "none"; });

for (const name of ["faces", "intrinsic", "input"])
  element(name).addEventListener("change", event => {
    layers[name].visible = event.target.checked;
    layers.input.material.uniforms.rgb.value = faces.visible ? white : grey; // the page is light
    draw();
  });
function showField() {
  const on = field && element("scalar").checked;
  geometry.setAttribute("color", attribute(on ? field : plain, true));
  element("legend").style.display = on ? "block" : "none";
  draw();
}
element("scalar").addEventListener("change", showField);
element("reset").addEventListener("click", reset);
element("shot").addEventListener("click", () => {
  draw();
  const link = document.createElement("a");
  link.download = document.title.replace(/[^A-Za-z0-9._-]+/g, "_") + ".png";
  link.href = renderer.domElement.toDataURL("image/png");
  link.click();
});
window.addEventListener("resize", resize);
controls.addEventListener("change", draw);
reset();
showField();
resize(); // at the end, when the panel has its size
(function loop() {
  requestAnimationFrame(loop);
  controls.update();
  hover();
})();
})();
</script>
</body>
</html>
)page";

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PROGRAM_H
