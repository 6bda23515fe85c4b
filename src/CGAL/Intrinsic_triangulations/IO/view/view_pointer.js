R"page(// ---- What is under the pointer: numbers of triangles are drawn to one pixel ----
const target = new THREE.WebGLRenderTarget(1, 1), pixel = new Uint8Array(4);
function numberAt(view, eye, [width, height], x, y) {
  eye.setViewOffset(width, height, x, y, 1, 1);
  const background = renderer.getClearColor().clone();
  renderer.setRenderTarget(target);
  renderer.setClearColor(0);
  renderer.clear();
  renderer.render(view.pick, eye);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
  renderer.setRenderTarget(null);
  renderer.setClearColor(background);
  eye.clearViewOffset();
  place();
  return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
}
const corner = new THREE.Vector3();
function distanceAt(places, v, eye, [width, height], x, y) {
  corner.fromArray(places, 3 * v).project(eye);
  return Math.hypot((corner.x + 1) / 2 * width - x, (1 - corner.y) / 2 * height - y);
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
function valuesText(v) {
  return [description(v), ...fields.filter(f => f === shown || fields.length < 5).map(f =>
    nameOf(f) + " there: " + (f.isClass ? Math.round(valueAt(f, v)) : valueAt(f, v).toPrecision(6)))]
    .join("\n");
}
let pointer = null, planePointer = null, shown = null;
function eyeDistance(places, i) { return corner.fromArray(places, 3 * i).distanceTo(camera.position); }
function markText(v, x, y) {
  for (const i of markLabel.keys())
    if (distanceAt(mark, i, camera, [size.x, size.y], x, y) < 9 &&
      eyeDistance(mark, i) < eyeDistance(point, v) + 0.1)
      return "\n" + settings.marks + (markLabel[i] === 0 ? "" : ", index " + markLabel[i]);
  return "";
}
function hover() {
  const isInPlane = planePointer !== null;
  if (!pointer && !isInPlane) return;
  const [x, y] = planePointer || pointer, box = element("hover");
  const [view, eye, extent] = isInPlane ? [plane, planeCamera, planeSize()] :
    [surface, camera, [size.x, size.y]];
  const t = isInPlane ? numberAt(view, eye, extent, x, y) :
    numberAt(view, eye, extent, x - shift[0], y - shift[1]);
  pointer = planePointer = null;
  box.style.display = t >= 0 && t < count ? "block" : "none";
  if (t < 0 || t >= count) return;
  const v = nearestVertex(t, i => distanceAt(view.point, i, eye, extent, x, y));
  let text = "intrinsic face " + source[2 * t] + "\ninput face " + source[2 * t + 1] +
    (isCover ? sheet[t] === 0 ? ", front" : ", back" : "") + "\nnearest: " + valuesText(v);
  if (!isInPlane) text += markText(v, x, y);
  box.textContent = text;
}
renderer.domElement.addEventListener("mousemove", event => {
  if (event.buttons === 0) pointer = [event.clientX, event.clientY];
});
for (const part of [renderer.domElement, element("plane")])
  part.addEventListener("mouseleave", () => { element("hover").style.display = "none"; });

// ---- A vertex by its number in the file ----
const found = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ color: 0xff2d95,
  size: 13, sizeAttenuation: false, depthTest: false, transparent: true }));
found.visible = found.frustumCulled = false;
found.renderOrder = 20;
scene.add(found);
function goToVertex(number) {
  let v = 0;
  while (v < kind.length && (kind[v] !== 0 || label[2 * v + 1] !== number)) ++v;
  const box = element("hover");
  box.style.display = "block";
  if (v === kind.length) {
    box.textContent = "no vertex " + number + " on this page";
    return;
  }
  const at = point.slice(3 * v, 3 * v + 3), eye = new THREE.Vector3();
  for (let i = 0; i < 3 * count; ++i)
    if (triangle[i] === v)
      eye.add(new THREE.Vector3(flatNormal[3 * i], flatNormal[3 * i + 1], flatNormal[3 * i + 2]));
  found.geometry.setAttribute("position", attribute(at));
  found.visible = true;
  isMoved = true;
  const up = new THREE.Vector3(...element("up").value.split(",").map(Number));
  if (eye.length() < 1e-6) eye.copy(camera.position);
  eye.normalize();
  if (Math.abs(eye.dot(up)) > 0.95) up.set(up.y, up.z, up.x);
  look(new THREE.Vector3(...at), eye, 0.7, up);
  box.textContent = valuesText(v);
}
element("goto").addEventListener("change", event => {
  if (event.target.value !== "") goToVertex(Number(event.target.value));
});

)page"
