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
const manyFaces = count > 60000;
function sample(n, places, step) {
  const most = Math.min(n, manyFaces ? 8 : 24), at = k => step * Math.floor((k + 0.5) * n / most);
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
// from the side, or from above or below, where clearly more of the subjects are seen.
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
  const views = [[0.8, 0.45, rise], [0.8, -0.45, rise], [-0.8, 0.45, rise], [-0.8, -0.45, rise]];
  if (!manyFaces)
    for (const r of [rise, 1.5, -0.5])
      for (const [s, t] of [[1, 0], [-1, 0], [0, 1], [0, -1], [0.6, 0.8], [0.6, -0.8], [-0.6, 0.8],
        [-0.6, -0.8]]) views.push([s, t, r]);
  const [first, ...others] = views.map(([s, t, r]) => unit(a).multiplyScalar(s)
    .addScaledVector(unit(b), t).addScaledVector(up, r).normalize());
  let eye = first, most = 1.2 * seenFrom(first);
  for (const other of others) {
    const seen = most < subjects.length ? seenFrom(other) : 0;
    if (seen > most) [eye, most] = [other, seen];
  }
  return { eye: eye, up: top };
}
// The place to look at and the distance with which all points are in the part of the window that is
// free, when looking along `eye`.
function fit(eye, up) {
  const right = new THREE.Vector3().crossVectors(up, eye).normalize();
  const upwards = new THREE.Vector3().crossVectors(eye, right);
  const axes = [right, upwards, eye], [w, h] = freeSize();
  const tan = Math.tan(camera.fov * Math.PI / 360), most = [0.92 * tan * w / windowSize.y,
    0.92 * tan * h / windowSize.y];
  const coordinate = (i, c) => point[i] * axes[c].x + point[i + 1] * axes[c].y + point[i + 2] * axes[c].z;
  const middle = [0, 1].map(c => {
    let least = Infinity, greatest = -Infinity;
    for (let i = 0; i < point.length; i += 3) {
      least = Math.min(least, coordinate(i, c));
      greatest = Math.max(greatest, coordinate(i, c));
    }
    return (least + greatest) / 2;
  });
  let distance = 0.2;
  for (let i = 0; i < point.length; i += 3)
    for (const c of [0, 1])
      distance = Math.max(distance, coordinate(i, 2) + Math.abs(coordinate(i, c) - middle[c]) / most[c]);
  return { target: right.multiplyScalar(middle[0]).addScaledVector(upwards, middle[1]),
    distance: distance };
}
let isMoved = false;
function look(target, eye, distance, up) {
  controls.reset();
  controls.target.copy(target);
  camera.position.copy(target).addScaledVector(eye, distance);
  camera.up.copy(up);
  camera.lookAt(target);
  controls.update();
  draw();
}
function reset() {
  const view = aim(), place = fit(view.eye, view.up);
  look(place.target, view.eye, place.distance, view.up);
  isMoved = false;
}
// The clipping planes follow the unit ball, so that depths are precise.
function clip() {
  const distance = camera.position.length();
  camera.near = Math.max(distance - 1.05, 0.002);
  camera.far = distance + 1.05;
  camera.updateProjectionMatrix();
  pixelsPerUnit.value = size.y / (2 * Math.tan(camera.fov * Math.PI / 360));
}
// The plane has a part of the window of its own: on the right, or below in a narrow window.
const planeCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.5, 2);
const planeView = { x: 0, y: 0, zoom: 1 }, windowSize = new THREE.Vector2(1, 1);
const isPlaneShown = () => plane && element("plane-shown").checked;
const isStacked = () => windowSize.x < windowSize.y;
function planeSize() {
  if (!isPlaneShown()) return [0, 0];
  return isStacked() ? [windowSize.x, Math.round(0.45 * windowSize.y)]
    : [Math.round((windowSize.x - panelWidth()) / 2), windowSize.y];
}
// Where the panel is beside the model, not on it.
function panelWidth() {
  const panel = element("panel"), isAside = panel.classList.contains("folded") ||
    panel.style.visibility === "hidden";
  const width = isAside ? 0 : panel.offsetWidth + 12;
  return windowSize.x > 2.5 * width ? width : 0;
}
function freeSize() {
  const [w, h] = planeSize();
  return isStacked() ? [windowSize.x - panelWidth(), windowSize.y - h]
    : [windowSize.x - panelWidth() - w, windowSize.y];
}
if (plane && reach[2] > 0) {
  planeView.x = planeReach.value.x;
  planeView.y = planeReach.value.y;
}
function aimAtPlane() {
  const [w, h] = planeSize(), extent = reach[2] > 0 ? [2 * reach[2], 2 * reach[2]] : uvSize;
  const half = 0.54 * Math.max(extent[0] * h / w, extent[1]) / planeView.zoom;
  planeCamera.position.set(planeView.x, planeView.y, 1);
  planeCamera.top = half;
  planeCamera.bottom = -half;
  planeCamera.right = half * w / h;
  planeCamera.left = -planeCamera.right;
  planeCamera.updateProjectionMatrix();
  return half;
}
// Draws soon: once, however often it is called before.
let isDrawing = false;
function draw() {
  if (isDrawing) return;
  isDrawing = true;
  requestAnimationFrame(() => { isDrawing = false; drawNow(); });
}
function drawNow() {
  clip();
  renderer.setViewport(0, 0, windowSize.x, windowSize.y);
  renderer.render(scene, camera);
  drawTriad();
  element("plane").style.display = isPlaneShown() ? "block" : "none";
  if (!isPlaneShown()) return;
  const [w, h] = planeSize(), left = windowSize.x - w;
  element("plane").style.width = w + "px";
  element("plane").style.height = h + "px";
  pixelsPerUnit.value = h / (2 * aimAtPlane());
  size.set(w, h);
  renderer.setScissorTest(true);
  renderer.setScissor(left, 0, w, h);
  renderer.setViewport(left, 0, w, h);
  renderer.render(plane.scene, planeCamera);
  renderer.setScissorTest(false);
  renderer.setViewport(0, 0, windowSize.x, windowSize.y);
  size.copy(windowSize);
}
// The axes of the file, as they are seen: the farthest one is drawn first.
function drawTriad() {
  const turn = new THREE.Matrix4().getInverse(camera.matrixWorld);
  element("triad").innerHTML = ["x", "y", "z"].map((name, i) => ({ name: name, color:
    ["#c62828", "#2e7d32", "#1565c0"][i], d: new THREE.Vector3().setComponent(i, 1)
    .transformDirection(turn) })).sort((a, b) => a.d.z - b.d.z).map(({ name, color, d }) =>
    `<line x2="${24 * d.x}" y2="${-24 * d.y}" stroke="${color}" stroke-width="2.5"/><text x="${31 * d.x}"
    y="${4.5 - 31 * d.y}" text-anchor="middle" fill="${color}">${name}</text>`).join("");
}
element("plane").addEventListener("wheel", event => {
  event.preventDefault();
  planeView.zoom = Math.min(Math.max(planeView.zoom * Math.exp(-event.deltaY / 500), 0.5), 500);
  draw();
}, { passive: false });
element("plane").addEventListener("mousemove", event => {
  planePointer = event.buttons === 0 ? [event.offsetX, event.offsetY] : null;
  if (event.buttons === 0) return;
  const unit = 2 * aimAtPlane() / planeSize()[1];
  planeView.x -= event.movementX * unit;
  planeView.y += event.movementY * unit;
  draw();
});
// The model is in the middle of what the panel and the plane leave free.
let shift = [0, 0];
function place() { camera.setViewOffset(size.x, size.y, -shift[0], -shift[1], size.x, size.y); }
function resize() {
  windowSize.set(window.innerWidth, window.innerHeight);
  renderer.setSize(windowSize.x, windowSize.y);
  size.copy(windowSize);
  const [w, h] = planeSize();
  shift = isStacked() ? [panelWidth() / 2, -h / 2] : [(panelWidth() - w) / 2, 0];
  camera.aspect = windowSize.x / windowSize.y;
  place();
  controls.handleResize();
  if (isMoved) draw(); else reset();
}
controls.addEventListener("start", () => { isMoved = true; });
renderer.domElement.addEventListener("wheel", () => { isMoved = true; });

)page"
