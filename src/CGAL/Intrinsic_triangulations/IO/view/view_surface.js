R"page(const element = id => document.getElementById(id);
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
const settings = element("settings").dataset;
const fields = Array.from({ length: Number(settings.fields) }, (_, i) => {
  const data = element("field-" + i).dataset; // values are from 0 to 1; the range is in double precision
  const [least, greatest] = [Number(data.least), Number(data.greatest)];
  const values = decode("field-" + i, Float32Array);
  return { name: data.name, values: values, least: least, greatest: greatest, low: least,
    high: greatest, drawn: values, isClass: data.classes === "1", isConstant: !(least < greatest) };
});
const valueAt = (f, v) => f.least * (1 - f.values[v]) + f.greatest * f.values[v];
const texture = decode("texture", Float32Array); // two numbers per vertex, or none
const isDisk = settings.disk === "1"; // whether these are in Poincare's disk: (0.5, 0.5) is its centre
// Where a logarithm ends: its origin among the places, and how far it is a map from there; 0: nowhere.
const reach = (settings.reach || "0,0,0").split(",").map(Number);
const sheet = decode("sheets", Uint8Array); // of each triangle of a cover: 0 front, 1 back
const count = triangle.length / 3, isCover = sheet.length > 0;

// ---- Faces: three corners of their own, with a normal, a colour and a number to be picked by ----
const position = new Float32Array(9 * count);
const plain = new Uint8Array(9 * count), pick = new Uint8Array(9 * count);
for (let t = 0; t < count; ++t)
  for (let k = 0; k < 3; ++k)
    for (let c = 0; c < 3; ++c) {
      position[9 * t + 3 * k + c] = point[3 * triangle[3 * t + k] + c];
      plain[9 * t + 3 * k + c] = color[3 * t + c];
      pick[9 * t + 3 * k + c] = ((t + 1) >> (8 * c)) & 255;
    }
// An input face is flat: slivers that it was cut into take the normal of the whole side of it.
const sideOf = t => 2 * source[2 * t + 1] + (isCover ? sheet[t] : 0);
let sideCount = 0;
for (let t = 0; t < count; ++t) sideCount = Math.max(sideCount, sideOf(t) + 1);
const areaVector = new Float64Array(3 * sideCount);
for (let t = 0; t < count; ++t) {
  const p = position.subarray(9 * t, 9 * t + 9), f = 3 * sideOf(t);
  const u = [p[3] - p[0], p[4] - p[1], p[5] - p[2]], v = [p[6] - p[0], p[7] - p[1], p[8] - p[2]];
  areaVector[f] += u[1] * v[2] - u[2] * v[1];
  areaVector[f + 1] += u[2] * v[0] - u[0] * v[2];
  areaVector[f + 2] += u[0] * v[1] - u[1] * v[0];
}
const flatNormal = new Float32Array(9 * count);
for (let t = 0; t < count; ++t) {
  const n = areaVector.subarray(3 * sideOf(t), 3 * sideOf(t) + 3);
  const length = Math.hypot(n[0], n[1], n[2]) || 1;
  for (let k = 0; k < 9; ++k) flatNormal[9 * t + k] = n[k % 3] / length;
}
// Smooth: the mean, by areas, of the faces at a vertex whose normals are nearer than 40 degrees.
function smoothNormals() {
  const begin = new Uint32Array(point.length / 3 + 1), corners = new Uint32Array(3 * count);
  for (const v of triangle) ++begin[v + 1];
  for (let v = 0; v + 1 < begin.length; ++v) begin[v + 1] += begin[v];
  const next = begin.slice(), result = flatNormal.slice();
  triangle.forEach((v, i) => { corners[next[v]++] = i; });
  const area = Float64Array.from({ length: count }, (_, t) => {
    const p = position.subarray(9 * t, 9 * t + 9);
    const u = [p[3] - p[0], p[4] - p[1], p[5] - p[2]], v = [p[6] - p[0], p[7] - p[1], p[8] - p[2]];
    return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  });
  const n = flatNormal, most = 200; // faces at a vertex that are looked at
  for (let i = 0; i < 3 * count; ++i) {
    let x = 0, y = 0, z = 0;
    const last = Math.min(begin[triangle[i] + 1], begin[triangle[i]] + most);
    for (let k = begin[triangle[i]]; k < last; ++k) {
      const j = 3 * corners[k], w = area[Math.floor(corners[k] / 3)];
      if (n[j] * n[3 * i] + n[j + 1] * n[3 * i + 1] + n[j + 2] * n[3 * i + 2] < 0.766) continue;
      x += w * n[j]; y += w * n[j + 1]; z += w * n[j + 2];
    }
    const length = Math.hypot(x, y, z);
    if (length > 0) result.set([x / length, y / length, z / length], 3 * i);
  }
  return result;
}
// Whether the triangle of a corner has places in the plane: all of its corners have one.
const hasPlace = i => [0, 1, 2].every(k => isFinite(texture[2 * triangle[i - i % 3 + k]]));
// What is drawn between corners: a value, places for a checkerboard, and whether the value is one.
const drawnAttribute = new THREE.BufferAttribute(new Float32Array(12 * count), 4);
// Of classes, those of all corners of the triangle, and how strong each of them is at this one.
const classesAttribute = fields.some(f => f.isClass) &&
  new THREE.BufferAttribute(new Float32Array(9 * count), 3);
const strengthAttribute = classesAttribute &&
  new THREE.BufferAttribute(new Float32Array(9 * count), 3);
function drawValues(values) {
  for (let i = 0; i < 3 * count; ++i) {
    const x = values ? values[triangle[i]] : 0;
    drawnAttribute.array[4 * i] = isFinite(x) ? x : 0;
    drawnAttribute.array[4 * i + 3] = isFinite(x) ? 1 : 0;
  }
  drawnAttribute.needsUpdate = true;
}
function drawClasses(classes, strengths) { // of each vertex; -1: none
  for (let i = 0; i < 9 * count; ++i)
    classesAttribute.array[i] = classes[triangle[3 * Math.floor(i / 9) + i % 3]];
  strengthAttribute.array.set(strengths);
  classesAttribute.needsUpdate = strengthAttribute.needsUpdate = true;
}
for (let i = 0; i < 3 * count; ++i)
  for (let c = 0; c < 2 && texture.length > 0; ++c)
    drawnAttribute.array[4 * i + 1 + c] = hasPlace(i) ? texture[2 * triangle[i] + c] : -1;
function attribute(array, normalized) { return new THREE.BufferAttribute(array, 3, normalized); }
function facesAt(places) {
  const g = new THREE.BufferGeometry();
  g.setAttribute("position", attribute(places));
  g.setAttribute("normal", normalAttribute);
  g.setAttribute("color", plainAttribute);
  g.setAttribute("drawn", drawnAttribute);
  g.setAttribute("pick", pickAttribute);
  if (classesAttribute) {
    g.setAttribute("classes", classesAttribute);
    g.setAttribute("strength", strengthAttribute);
  }
  return g;
}
const normalAttribute = attribute(flatNormal.slice()), plainAttribute = attribute(plain, true);
const pickAttribute = attribute(pick, true), offset = { polygonOffset: true, polygonOffsetFactor: 1,
  polygonOffsetUnits: 1, side: THREE.DoubleSide };
// The eye carries the light: what faces it is bright. What is beyond the plane `cut` is not drawn.
const levels = { value: 0 }, squares = { value: 0 }, range = { value: new THREE.Vector2(0, 1) };
const kindOfColor = { value: 0 }, cut = { value: new THREE.Vector4(0, 0, 0, 1) };
const noCut = { value: new THREE.Vector4(0, 0, 0, 1) }, opacity = { value: 1 };
const shadedMaterial = (cut, light) => new THREE.ShaderMaterial(Object.assign({ uniforms: {
  levels: levels, squares: squares, range: range, kind: kindOfColor, map: { value: mapTexture }, cut: cut,
  light: { value: light }, disk: { value: isDisk ? 1 : 0 }, opacity: opacity,
  reach: { value: new THREE.Vector3(...reach) } }, extensions: { derivatives: true }, vertexShader: `
  attribute vec3 color; attribute vec4 drawn; attribute vec3 classes; attribute vec3 strength;
  varying vec3 c; varying vec3 n; varying vec3 e; varying vec4 s; varying vec3 x; varying vec3 k; varying vec3 b;
  void main() { c = color; s = drawn; n = normalMatrix * normal; x = position; k = classes; b = strength;
    vec4 p = modelViewMatrix * vec4(position, 1.0); e = p.xyz; gl_Position = projectionMatrix * p; }`,
  fragmentShader: `
  varying vec3 c; varying vec3 n; varying vec3 e; varying vec4 s; varying vec3 x; varying vec3 k; varying vec3 b;
  uniform float levels; uniform float squares; uniform vec2 range; uniform float kind;
  uniform sampler2D map; uniform vec4 cut; uniform float light; uniform float disk;
  uniform float opacity; uniform vec3 reach;
  // Whether a place is in a dark tile. Reflections in the sides of a pentagon with five right angles
  // about the centre of Poincare's disk bring it into the pentagon, which is ten triangles; in the
  // flat plane tiles are squares.
  bool isDark(vec2 z) {
    if (disk < 0.5) return mod(floor(z.x * squares) + floor(z.y * squares), 2.0) > 0.5;
    z = 2.0 * z - 1.0;
    const float cosine = 0.30901699437, turn = 1.25663706144; // of 72 degrees
    float flips = 0.0, away = inversesqrt(cosine), square = 1.0 / cosine - 1.0;
    for (int n = 0; n < 60; ++n) {
      float at = turn * floor(atan(z.y, z.x) / turn + 0.5);
      vec2 d = z - away * vec2(cos(at), sin(at));
      if (dot(d, d) >= square) break;
      z = z - d + d * (square / dot(d, d));
      flips += 1.0;
    }
    return mod(flips + floor(2.0 * atan(z.y, z.x) / turn), 2.0) > 0.5;
  }
  vec3 colorAt(float y) { return texture2D(map, vec2((255.0 * clamp(y, 0.0, 1.0) + 0.5) / 256.0, 0.5)).rgb; }
  // The strongest class, and by how much it is stronger than others.
  vec2 strongestClass() {
    float best = b.x >= b.y && b.x >= b.z ? k.x : b.y >= b.z ? k.y : k.z;
    vec3 other = b - 10.0 * (1.0 - step(0.5, abs(k - best)));
    return vec2(best, max(b.x, max(b.y, b.z)) - max(other.x, max(other.y, other.z)));
  }
  void main() {
    if (dot(cut.xyz, x) > cut.w) discard;
    float away = distance(s.yz, reach.xy);
    if (light > 0.5 && reach.z > 0.0 && away > reach.z) discard;
    float d = length(n) > 0.0 ? abs(dot(normalize(n), normalize(e))) : 1.0;
    float shade = mix(0.4 + 0.52 * d, 0.92, light);
    vec3 rgb = kind < 0.5 ? vec3(0.886, 0.898, 0.918) : c; // one colour, or one for each face
    if (kind > 1.5 && kind < 2.5) { // the colour of a value, grey where there is none
      float y = (s.x - range.x) / max(range.y - range.x, 1e-30);
      rgb = s.w > 0.999 ? colorAt(y) : vec3(0.5);
      // A line of two pixels where a level is passed; none where the value is constant.
      float z = y * levels, w = fwidth(z);
      if (levels > 0.0 && s.w > 0.999 && w > 1e-4)
        shade *= mix(0.25, 1.0, smoothstep(0.6, 1.4, abs(fract(z - 0.5) - 0.5) / w));
    }
    if (kind > 2.5) { // classes, with dark lines between them
      vec2 nearest = strongestClass();
      rgb = nearest.x < -0.5 ? vec3(0.5) : colorAt(mod(nearest.x, 256.0) / 255.0);
      if (nearest.y < 1.0) shade *= mix(0.2, 1.0, smoothstep(0.8, 1.6, nearest.y / max(fwidth(nearest.y), 1e-6)));
    }
    if (squares > 0.0 && s.y > -0.5 && (reach.z == 0.0 || away < reach.z) && isDark(s.yz)) shade *= 0.45;
    gl_FragColor = vec4(rgb * shade, mix(opacity, 1.0, light)); }` }, offset));
const pickedMaterial = cut => new THREE.ShaderMaterial(Object.assign({ uniforms: { cut: cut },
  vertexShader: `attribute vec3 pick; varying vec3 c; varying vec3 x;
  void main() { c = pick; x = position;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
  fragmentShader: `varying vec3 c; varying vec3 x; uniform vec4 cut;
  void main() { if (dot(cut.xyz, x) > cut.w) discard; gl_FragColor = vec4(c, 1.0); }` }, offset));
// What is seen: the surface and, where there are places in the plane, these.
function seen(places, corners, cut, light) {
  const view = { point: places, cut: cut, ends: light > 0.5 ? planeReach : noReach, scene: new THREE.Scene(), pick: new THREE.Scene(),
    geometry: facesAt(corners) };
  view.scene.background = new THREE.Color(0xf4f5f7);
  view.faces = new THREE.Mesh(view.geometry, shadedMaterial(cut, light));
  view.scene.add(view.faces);
  view.pick.add(new THREE.Mesh(view.geometry, pickedMaterial(cut)));
  return view;
}
const uvSize = [0, 0];
for (let i = 0; i < texture.length; ++i)
  if (isFinite(texture[i])) uvSize[i % 2] = isDisk ? 1 : Math.max(uvSize[i % 2], texture[i]);
// The same in the plane of u and v, whose centre is in the middle of the places.
const planeReach = { value: new THREE.Vector3(reach[0] - uvSize[0] / 2, reach[1] - uvSize[1] / 2, reach[2]) };
const noReach = { value: new THREE.Vector3(0, 0, 0) };
const surface = seen(point, position, cut, 0), views = [surface];
if (texture.length > 0) {
  const flat = new Float32Array(point.length), corners = new Float32Array(9 * count);
  for (let v = 0; v < point.length / 3; ++v)
    for (let c = 0; c < 2; ++c) flat[3 * v + c] = texture[2 * v + c] - uvSize[c] / 2;
  for (let i = 0; i < 3 * count; ++i)
    if (hasPlace(i)) corners.set(flat.subarray(3 * triangle[i], 3 * triangle[i] + 3), 3 * i);
  views.push(seen(flat, corners, noCut, 1));
}
const plane = views[1], scene = surface.scene;

)page"
