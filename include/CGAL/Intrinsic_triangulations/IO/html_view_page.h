// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_HTML_VIEW_PAGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_HTML_VIEW_PAGE_H

#include <string_view>

/*!
\file
The fixed parts of the page that `write_html_view()` writes: style and elements, and the program that
draws. Between them come three.js and the data.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// After the title.
inline constexpr std::string_view html_view_style = R"page(<style>
html, body { margin: 0; height: 100%; overflow: hidden; background: #f4f5f7;
  font: 14px/1.4 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1c2430; }
canvas { display: block; }
#panel { position: absolute; top: 12px; left: 12px; max-width: 300px; padding: 10px 14px;
  background: rgba(255, 255, 255, 0.92); border: 1px solid #d5d9e0; border-radius: 8px; }
#panel h1 { font-size: 16px; margin: 0 0 4px; overflow-wrap: anywhere; }
#panel p { margin: 0 0 8px; color: #536072; font-size: 12px; white-space: pre-line; }
#panel label { display: block; cursor: pointer; }
#panel button { margin: 8px 6px 0 0; padding: 3px 10px; border: 1px solid #b9c0cb;
  border-radius: 5px; background: #fff; cursor: pointer; font: inherit; }
#legend { margin-top: 8px; display: none; font-size: 12px; }
#legend canvas { width: 100%; height: 12px; border-radius: 3px; }
#legend div { display: flex; justify-content: space-between; }
#hover { position: absolute; right: 12px; bottom: 12px; padding: 6px 12px; font-size: 13px;
  background: rgba(28, 36, 48, 0.88); color: #fff; border-radius: 6px; white-space: pre-line;
  display: none; font-variant-numeric: tabular-nums; }
#failure { position: absolute; top: 40%; width: 100%; text-align: center; font-size: 18px;
  display: none; }
</style>
</head>
<body>
<div id="failure"></div>
)page";

// After the panel's title and description.
inline constexpr std::string_view html_view_controls =
    R"page(<label><input type="checkbox" id="faces" checked> faces</label>
<label><input type="checkbox" id="intrinsic" checked> intrinsic edges</label>
<label><input type="checkbox" id="input" checked> input edges</label>
<label id="scalar-label" style="display: none"><input type="checkbox" id="scalar" checked>
<span id="scalar-name"></span></label>
<div id="legend"><canvas width="256" height="1"></canvas><div><span id="least"></span>
<span id="greatest"></span></div></div>
<button id="reset">Reset view</button><button id="shot">Screenshot</button>
</div>
<div id="hover"></div>
)page";

// The program, after the data.
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
const scalar = decode("scalars", Float32Array);
const count = triangle.length / 3;

// ---- Faces: three corners of their own, with a normal, a colour and a number to be picked by ----
const position = new Float32Array(9 * count), normal = new Float32Array(9 * count);
const plain = new Uint8Array(9 * count), pick = new Uint8Array(9 * count);
for (let t = 0; t < count; ++t) {
  for (let k = 0; k < 3; ++k)
    for (let c = 0; c < 3; ++c) {
      position[9 * t + 3 * k + c] = point[3 * triangle[3 * t + k] + c];
      plain[9 * t + 3 * k + c] = color[3 * t + c];
      pick[9 * t + 3 * k + c] = ((t + 1) >> (8 * c)) & 255;
    }
  const p = position.subarray(9 * t, 9 * t + 9);
  const u = [p[3] - p[0], p[4] - p[1], p[5] - p[2]], v = [p[6] - p[0], p[7] - p[1], p[8] - p[2]];
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
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
let field = null, least = Infinity, greatest = -Infinity;
if (scalar.length > 0) {
  for (const x of scalar) if (isFinite(x)) least = Math.min(least, x), greatest = Math.max(greatest, x);
  field = new Uint8Array(9 * count);
  for (let i = 0; i < 3 * count; ++i) {
    const x = scalar[triangle[i]];
    field.set(isFinite(x) ? mapped((x - least) / (greatest - least || 1)) : [128, 128, 128], 3 * i);
  }
  element("scalar-label").style.display = "block";
  const strip = document.querySelector("#legend canvas").getContext("2d");
  for (let i = 0; i < 256; ++i) {
    strip.fillStyle = "rgb(" + mapped(i / 255).join() + ")";
    strip.fillRect(i, 0, 1, 1);
  }
  element("least").textContent = least.toPrecision(5);
  element("greatest").textContent = greatest.toPrecision(5);
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
    gl_FragColor = vec4(c * (0.42 + 0.58 * d), 1.0); }` }, offset));
const picked = new THREE.ShaderMaterial(Object.assign({ vertexShader: `
  attribute vec3 pick; varying vec3 c;
  void main() { c = pick; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
  fragmentShader: `varying vec3 c; void main() { gl_FragColor = vec4(c, 1.0); }` }, offset));
const faces = new THREE.Mesh(geometry, shaded);
const scene = new THREE.Scene(), pickScene = new THREE.Scene();
scene.background = new THREE.Color(0xf4f5f7);
scene.add(faces);
pickScene.add(new THREE.Mesh(geometry, picked));

// ---- Edges: each a rectangle of constant width on the screen ----
const size = new THREE.Vector2(1, 1);
function edges(id, width, rgb, depth) {
  const ends = decode(id, Uint32Array), n = ends.length / 2;
  const start = new Float32Array(12 * n), end = new Float32Array(12 * n);
  const corner = new Float32Array(8 * n), index = new Uint32Array(6 * n);
  for (let s = 0; s < n; ++s) {
    for (let k = 0; k < 4; ++k) {
      for (let c = 0; c < 3; ++c) {
        start[12 * s + 3 * k + c] = point[3 * ends[2 * s] + c];
        end[12 * s + 3 * k + c] = point[3 * ends[2 * s + 1] + c];
      }
      corner.set([k >> 1, 2 * (k & 1) - 1], 8 * s + 2 * k);
    }
    index.set([0, 1, 2, 2, 1, 3].map(k => 4 * s + k), 6 * s);
  }
  const g = new THREE.BufferGeometry();
  g.setAttribute("position", attribute(start));
  g.setAttribute("end", attribute(end));
  g.setAttribute("corner", new THREE.BufferAttribute(corner, 2));
  g.setIndex(new THREE.BufferAttribute(index, 1));
  const material = new THREE.ShaderMaterial({ side: THREE.DoubleSide, uniforms: {
    size: { value: size }, width: { value: width }, rgb: { value: new THREE.Color(rgb) },
    depth: { value: depth } }, vertexShader: `
    attribute vec3 end; attribute vec2 corner;
    uniform vec2 size; uniform float width; uniform float depth;
    void main() {
      vec4 a = modelViewMatrix * vec4(position, 1.0), b = modelViewMatrix * vec4(end, 1.0);
      // cut what is behind the eye, where nothing can be projected
      float near = -0.001;
      if (a.z > near && b.z < near) a = mix(b, a, (b.z - near) / (b.z - a.z));
      if (b.z > near && a.z < near) b = mix(a, b, (a.z - near) / (a.z - b.z));
      a = projectionMatrix * a; b = projectionMatrix * b;
      vec2 d = (b.xy / b.w - a.xy / a.w) * size;
      d = length(d) > 1e-6 ? normalize(d) : vec2(1.0, 0.0);
      vec4 p = corner.x < 0.5 ? a : b;
      p.xy += (vec2(-d.y, d.x) * corner.y + d * (2.0 * corner.x - 1.0)) * width / size * p.w;
      p.z -= depth * p.w;
      gl_Position = p;
    }`, fragmentShader: `uniform vec3 rgb; void main() { gl_FragColor = vec4(rgb, 1.0); }` });
  const mesh = new THREE.Mesh(g, material);
  mesh.frustumCulled = false;
  scene.add(mesh);
  return mesh;
}
const layers = { faces: faces, input: edges("input-edges", 0.55, 0xffffff, 2e-5),
  intrinsic: edges("intrinsic-edges", 1.0, 0x10151d, 4e-5) };

// ---- The camera: points are scaled to the unit ball ----
const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 20);
const controls = new THREE.TrackballControls(camera, renderer.domElement);
controls.rotateSpeed = 3;
controls.staticMoving = true;
const up = decode("view-axes", Float32Array);
function reset() {
  controls.reset();
  controls.target.set(0, 0, 0);
  camera.position.set(up[0], up[1], up[2]).multiplyScalar(2.75);
  camera.up.set(up[3], up[4], up[5]);
  camera.lookAt(0, 0, 0);
  controls.update();
  draw();
}
function draw() { renderer.render(scene, camera); }
function resize() {
  const w = window.innerWidth, h = window.innerHeight;
  renderer.setSize(w, h);
  size.set(w, h);
  camera.aspect = w / h;
  camera.fov = w < h ? 2 * Math.atan(Math.tan(Math.PI / 9) * h / w) * 180 / Math.PI : 40;
  camera.updateProjectionMatrix();
  controls.handleResize();
  draw();
}

// ---- What is under the pointer: numbers of triangles are drawn to one pixel ----
const target = new THREE.WebGLRenderTarget(1, 1), pixel = new Uint8Array(4);
function numberAt(x, y) {
  const ratio = renderer.getPixelRatio(), w = window.innerWidth * ratio, h = window.innerHeight * ratio;
  camera.setViewOffset(w, h, x * ratio, y * ratio, 1, 1);
  const background = renderer.getClearColor().clone();
  renderer.setRenderTarget(target);
  renderer.setClearColor(0);
  renderer.clear();
  renderer.render(pickScene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
  renderer.setRenderTarget(null);
  renderer.setClearColor(background);
  camera.clearViewOffset();
  return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
}
let pointer = null;
function hover() {
  if (!pointer) return;
  const t = numberAt(pointer[0], pointer[1]), box = element("hover");
  pointer = null;
  box.style.display = t >= 0 && t < count ? "block" : "none";
  if (t < 0 || t >= count) return;
  let text = "intrinsic face " + source[2 * t] + "\ninput face " + source[2 * t + 1];
  if (field) text += "\nvalues " + [0, 1, 2].map(k => scalar[triangle[3 * t + k]].toPrecision(5)).join(", ");
  box.textContent = text;
}
renderer.domElement.addEventListener("mousemove", event => {
  if (event.buttons === 0) pointer = [event.clientX, event.clientY];
});
renderer.domElement.addEventListener("mouseleave", () => { element("hover").style.display = "none"; });

for (const name of ["faces", "intrinsic", "input"])
  element(name).addEventListener("change", event => {
    layers[name].visible = event.target.checked;
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
resize();
reset();
showField();
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_HTML_VIEW_PAGE_H
