R"page(// ---- The camera: points are scaled to the unit ball ----
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
const controls = new THREE.TrackballControls(camera, renderer.domElement);
controls.rotateSpeed = 3;
controls.staticMoving = true;
const [upX, upY, upZ, ...box] = decode("view-axes", Float32Array); // sides, height of the base
const standing = [upX, upY, upZ].join();
if (![...element("up").options].some(option => option.value === standing))
  element("up").add(new Option("base", standing), 0);
element("up").value = standing;
// What the page is about: some marked points, and some places on curves.
function sample(n, places, step) {
  const most = Math.min(n, 16), at = k => step * Math.floor((k + 0.5) * n / most);
  return Array.from({ length: most }, (_, k) => places.subarray(at(k), at(k) + 3));
}
const subjects = [...sample(markLabel.length, mark, 3),
  ...sample(curveSets[1].label.length, curveSets[1].ends, 6)];
// Whether a triangle is between a place and the eye; those that touch the place do not count.
function isHidden(place, eye) {
  const d = [0, 1, 2].map(c => eye[c] - place[c]), least = 0.02 / Math.hypot(...d);
  for (let i = 0; i < position.length; i += 9) {
    const ux = position[i + 3] - position[i], uy = position[i + 4] - position[i + 1],
      uz = position[i + 5] - position[i + 2];
    const vx = position[i + 6] - position[i], vy = position[i + 7] - position[i + 1],
      vz = position[i + 8] - position[i + 2];
    const px = d[1] * vz - d[2] * vy, py = d[2] * vx - d[0] * vz, pz = d[0] * vy - d[1] * vx;
    const det = ux * px + uy * py + uz * pz;
    const x = place[0] - position[i], y = place[1] - position[i + 1], z = place[2] - position[i + 2];
    const a = (x * px + y * py + z * pz) / det;
    if (!(a >= 0 && a <= 1)) continue;
    const qx = y * uz - z * uy, qy = z * ux - x * uz, qz = x * uy - y * ux;
    const b = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
    if (b >= 0 && a + b <= 1 && (vx * qx + vy * qy + vz * qz) / det > least) return true;
  }
  return false;
}
const eyeDistanceAtFirst = 3.1;
function seenFrom(eye) {
  const at = eye.clone().multiplyScalar(eyeDistanceAtFirst).toArray();
  return subjects.filter(place => !isHidden(place, at)).length;
}
// Looks mostly along the shorter side of the box that is not up, and from above on what is flat;
// from the side where clearly more of the subjects are seen.
function aim() {
  const up = new THREE.Vector3(...element("up").value.split(",").map(Number));
  const along = up.toArray().map(Math.abs), axis = along.indexOf(Math.max(...along));
  const [a, b] = [0, 1, 2].filter(c => c !== axis).sort((i, j) => box[i] - box[j]);
  const unit = c =>
    new THREE.Vector3().setComponent(c, 1).addScaledVector(up, -up.getComponent(c)).normalize();
  const height = element("up").value === standing ? box[3] : box[axis], isFlat = height < 2e-6;
  const top = isFlat && along[1] > 0.9 ? new THREE.Vector3(0, 0, 1)
    : isFlat ? new THREE.Vector3(0, 1, 0) : up;
  if (isFlat) return { eye: up, up: top };
  const rise = height < 0.5 * box[a] ? 0.8 : 0.4;
  const [first, ...others] = [[1, 1], [1, -1], [-1, 1], [-1, -1]].map(([s, t]) =>
    unit(a).multiplyScalar(0.8 * s).addScaledVector(unit(b), 0.45 * t).addScaledVector(up, rise)
      .normalize());
  let eye = first, most = 1.2 * seenFrom(first);
  for (const other of others) {
    const seen = seenFrom(other);
    if (seen > most) [eye, most] = [other, seen];
  }
  return { eye: eye, up: top };
}
function reset() {
  controls.reset();
  controls.target.set(0, 0, 0);
  const view = aim();
  camera.position.copy(view.eye).multiplyScalar(eyeDistanceAtFirst);
  camera.up.copy(view.up);
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
// The plane has a part of the window of its own, on the right.
const planeCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.5, 2);
const planeView = { x: 0, y: 0, zoom: 1 }, windowSize = new THREE.Vector2(1, 1);
const isPlaneShown = () => plane && element("plane-shown").checked;
const planeWidth = () => isPlaneShown() ? Math.round(0.42 * windowSize.x) : 0;
function aimAtPlane() {
  const w = planeWidth(), h = windowSize.y;
  const half = 0.54 * Math.max(uvSize[0] * h / w, uvSize[1]) / planeView.zoom;
  planeCamera.position.set(planeView.x, planeView.y, 1);
  planeCamera.top = half;
  planeCamera.bottom = -half;
  planeCamera.right = half * w / h;
  planeCamera.left = -planeCamera.right;
  planeCamera.updateProjectionMatrix();
  return half;
}
function draw() {
  clip();
  renderer.setViewport(0, 0, windowSize.x, windowSize.y);
  renderer.render(scene, camera);
  element("plane").style.display = isPlaneShown() ? "block" : "none";
  if (!isPlaneShown()) return;
  const w = planeWidth(), left = windowSize.x - w;
  element("plane").style.width = w + "px";
  element("plane").style.height = windowSize.y + "px";
  pixelsPerUnit.value = windowSize.y / (2 * aimAtPlane());
  size.set(w, windowSize.y);
  renderer.setScissorTest(true);
  renderer.setScissor(left, 0, w, windowSize.y);
  renderer.setViewport(left, 0, w, windowSize.y);
  renderer.render(plane.scene, planeCamera);
  renderer.setScissorTest(false);
  renderer.setViewport(0, 0, windowSize.x, windowSize.y);
  size.copy(windowSize);
}
element("plane").addEventListener("wheel", event => {
  event.preventDefault();
  planeView.zoom = Math.min(Math.max(planeView.zoom * Math.exp(-event.deltaY / 500), 0.5), 500);
  draw();
}, { passive: false });
element("plane").addEventListener("mousemove", event => {
  planePointer = event.buttons === 0 ? [event.offsetX, event.offsetY] : null;
  if (event.buttons === 0) return;
  const unit = 2 * aimAtPlane() / windowSize.y;
  planeView.x -= event.movementX * unit;
  planeView.y += event.movementY * unit;
  draw();
});
// In a wide window the model is in the middle of what the panel and the plane leave free.
let shift = 0;
function look() { camera.setViewOffset(size.x, size.y, -shift, 0, size.x, size.y); }
function resize() {
  const w = window.innerWidth, h = window.innerHeight, panel = element("panel").offsetWidth;
  renderer.setSize(w, h);
  size.set(w, h);
  windowSize.copy(size);
  const left = w > 2.5 * panel ? panel : 0, right = planeWidth();
  shift = (left - right) / 2;
  const free = w - left - right;
  camera.aspect = w / h;
  camera.fov = free < h ? 2 * Math.atan(Math.tan(Math.PI / 9) * h / free) * 180 / Math.PI : 40;
  look();
  controls.handleResize();
  draw();
}

// ---- What is under the pointer: numbers of triangles are drawn to one pixel ----
const target = new THREE.WebGLRenderTarget(1, 1), pixel = new Uint8Array(4);
function numberAt(view, eye, width, x, y) {
  eye.setViewOffset(width, size.y, x, y, 1, 1);
  const background = renderer.getClearColor().clone();
  renderer.setRenderTarget(target);
  renderer.setClearColor(0);
  renderer.clear();
  renderer.render(view.pick, eye);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
  renderer.setRenderTarget(null);
  renderer.setClearColor(background);
  eye.clearViewOffset();
  look();
  return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
}
const corner = new THREE.Vector3();
function distanceAt(places, v, eye, width, x, y) {
  corner.fromArray(places, 3 * v).project(eye);
  return Math.hypot((corner.x + 1) / 2 * width - x, (1 - corner.y) / 2 * size.y - y);
}
// Triangles of one polygon are a fan, one after the other.
function nearestVertex(t, distance) {
  const is = s => s >= 0 && s < count && triangle[3 * s] === triangle[3 * t] &&
    source[2 * s] === source[2 * t] && source[2 * s + 1] === source[2 * t + 1];
  let first = t, last = t;
  while (is(first - 1)) --first;
  while (is(last + 1)) ++last;
  let best = triangle[3 * t];
  for (let i = 3 * first; i < 3 * last + 3; ++i)
    if (distance(triangle[i]) < distance(best)) best = triangle[i];
  return best;
}
function description(v) {
  const a = label[2 * v], b = label[2 * v + 1];
  if (kind[v] === 0) return "input vertex " + b + " (intrinsic " + a + ")";
  if (kind[v] === 1) return "inserted vertex " + a + " in input face " + b;
  return "crossing of intrinsic edge " + a + ", input edge " + b;
}
let pointer = null, planePointer = null, shown = null;
function eyeDistance(places, i) { return corner.fromArray(places, 3 * i).distanceTo(camera.position); }
function markText(v, x, y) {
  for (const i of markLabel.keys())
    if (distanceAt(mark, i, camera, size.x, x, y) < 9 &&
      eyeDistance(mark, i) < eyeDistance(point, v) + 0.1)
      return "\n" + settings.marks + (markLabel[i] === 0 ? "" : ", index " + markLabel[i]);
  return "";
}
function hover() {
  const isInPlane = planePointer !== null;
  if (!pointer && !isInPlane) return;
  const [x, y] = planePointer || pointer, box = element("hover");
  const [view, eye, width] = isInPlane ? [plane, planeCamera, planeWidth()] :
    [surface, camera, size.x];
  const t = numberAt(view, eye, width, isInPlane ? x : x - shift, y);
  pointer = planePointer = null;
  box.style.display = t >= 0 && t < count ? "block" : "none";
  if (t < 0 || t >= count) return;
  const v = nearestVertex(t, i => distanceAt(view.point, i, eye, width, x, y));
  let text = "intrinsic face " + source[2 * t] + "\ninput face " + source[2 * t + 1] +
    (isCover ? sheet[t] === 0 ? ", front" : ", back" : "") +
    "\nnearest: " + description(v);
  for (const f of fields)
    if (f === shown || fields.length < 5)
      text += "\n" + f.name + " there: " +
        (f.least * (1 - f.values[v]) + f.greatest * f.values[v]).toPrecision(6);
  if (!isInPlane) text += markText(v, x, y);
  box.textContent = text;
}
renderer.domElement.addEventListener("mousemove", event => {
  if (event.buttons === 0) pointer = [event.clientX, event.clientY];
});
for (const part of [renderer.domElement, element("plane")])
  part.addEventListener("mouseleave", () => { element("hover").style.display = "none"; });

for (const name of ["faces", "intrinsic", "input"])
  element(name).addEventListener("change", event => {
    for (const part of name === "faces" ? views.map(view => view.faces) : layers[name])
      part.visible = event.target.checked;
    showField();
  });
for (const name of ["intrinsic", "input"]) {
  element(name).checked = settings.edges === "shown";
  for (const part of layers[name]) part.visible = element(name).checked;
}
// The sides of a face are at the same place: one of them is drawn.
function showSheet() {
  if (!isCover) return;
  const shown = Number(element("sheet").value), corners = [];
  for (let t = 0; t < count; ++t)
    if (sheet[t] === shown) corners.push(3 * t, 3 * t + 1, 3 * t + 2);
  for (const view of views)
    view.geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(corners), 1));
  for (const layer of [...layers.input, ...layers.intrinsic])
    layer.children.forEach((part, i) => { part.visible = i === shown; });
  element("sheet-label").style.display = "block";
  draw();
}
element("sheet").addEventListener("change", showSheet);
fields.forEach((f, i) => element("field").add(new Option(f.name, i)));
for (const name of Object.keys(maps)) element("map").add(new Option(name));
element("field").value = settings.shown;
element("levels").value = settings.isolines;
function showMap() {
  const map = maps[element("map").value];
  const strip = document.querySelector("#legend canvas").getContext("2d");
  for (let i = 0; i < 256; ++i) {
    const rgb = mapped(map, i / 255);
    mapTexture.image.data.set([...rgb, 255], 4 * i);
    strip.fillStyle = "rgb(" + rgb.join() + ")";
    strip.fillRect(i, 0, 1, 1);
  }
  mapTexture.needsUpdate = true;
  draw();
}
const brief = x => String(Number(x.toPrecision(6)));
function showRange() {
  const f = shown, width = f.greatest - f.least;
  range.value.set(width > 0 ? (f.low - f.least) / width : 0, width > 0 ? (f.high - f.least) / width : 1);
  element("least").textContent = brief(f.low);
  element("middle").textContent = brief(f.low / 2 + f.high / 2);
  element("greatest").textContent = brief(f.high);
  element("low").value = brief(f.low);
  element("high").value = brief(f.high);
  levels.value = Number(element("levels").value);
}
function showField() {
  const name = element("field").value, f = fields[name] || null;
  if (f !== shown) drawValues(f && f.values);
  shown = f;
  kindOfColor.value = f ? 2 : name === "faces" ? 1 : 0;
  element("legend").style.display = f ? "block" : "none";
  if (f) showRange();
  const checks = texture.length > 0 && element("checks").checked;
  squares.value = checks ? 24 : 0;
  if (texture.length > 0) element("texture-label").style.display = "block";
  const isLight = !element("faces").checked || !f && name === "none"; // the page, or the faces
  for (const layer of layers.input)
    for (const part of layer.children) part.material.uniforms.rgb.value = isLight ? grey : white;
  draw();
}
function setRange(low, high) {
  if (!(low < high)) return showRange();
  shown.low = low;
  shown.high = high;
  showField();
}
for (const name of ["low", "high"])
  element(name).addEventListener("change",
    () => setRange(Number(element("low").value), Number(element("high").value)));
element("whole").addEventListener("click", () => setRange(shown.least, shown.greatest));
element("symmetric").addEventListener("click", () => {
  const most = Math.max(Math.abs(shown.least), Math.abs(shown.greatest));
  setRange(-most, most);
});
for (const name of ["field", "levels", "checks"]) element(name).addEventListener("change", showField);
element("map").addEventListener("change", showMap);
element("plane-shown").addEventListener("change", resize);
// ---- A plane that cuts the surface ----
let side = 1;
function showCut() {
  const axis = ["x", "y", "z"].indexOf(element("axis").value), normal = [0, 0, 0];
  normal[axis] = element("cut").checked ? side : 0;
  cut.value.set(...normal, element("cut").checked ? side * Number(element("cut-at").value) : 1);
  draw();
}
for (const name of ["cut", "axis"]) element(name).addEventListener("change", showCut);
element("cut-at").addEventListener("input", showCut);
element("flip").addEventListener("click", () => { side = -side; showCut(); });
element("reset").addEventListener("click", reset);
element("up").addEventListener("change", reset);
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
showMap();
showField();
showSheet();
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
)page"
