R"page(// ---- What is shown ----
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
// ---- Colours: one, those of intrinsic faces, or those of a field, with a legend ----
const nameOf = f => f.name.replace(/_/g, " ");
fields.forEach((f, i) => element("field").add(new Option(nameOf(f), i)));
for (const name of Object.keys(maps)) element("map").add(new Option(name));
element("field").value = settings.shown;
element("levels").value = settings.isolines;
function brief(x) {
  const size = Math.abs(x);
  return size !== 0 && (size >= 1e6 || size < 1e-3) ? x.toExponential(2).replace("e+", "e")
    : String(Number(x.toPrecision(4)));
}
function child(parent, kind, text, color) {
  const part = parent.appendChild(document.createElement(kind));
  if (color) part.appendChild(document.createElement("i")).style.background = color;
  part.appendChild(document.createTextNode(text));
}
// The legend of a field, and its colours in the texture.
function showMap() {
  const f = shown, map = maps[element("map").value], ticks = element("ticks");
  const classes = element("classes"), bar = document.querySelector("#legend canvas");
  element("legend").style.display = f ? "block" : "none";
  ticks.textContent = classes.textContent = "";
  if (!f) return draw();
  const strip = bar.getContext("2d"), isBar = !f.isClass && !f.isConstant;
  bar.style.display = isBar ? "block" : "none";
  for (let i = 0; i < 256; ++i) {
    const rgb = f.isClass ? classColor(i) : mapped(map, i / 255);
    mapTexture.image.data.set([...rgb, 255], 4 * i);
    strip.fillStyle = css(rgb);
    strip.fillRect(i, 0, 1, 1);
  }
  mapTexture.needsUpdate = true;
  element("legend-name").textContent = nameOf(f) + (f.isLogarithmic ? " (logarithmic)" : "");
  const most = 20;
  if (f.isClass) {
    f.classes.slice(0, most).forEach((x, i) => child(classes, "span", String(x), css(classColor(i % 256))));
    if (f.classes.length > most) child(classes, "span", "\u2026 " + f.classes.length + " in all");
  } else if (f.isConstant) child(classes, "span", brief(f.least) + " everywhere", css(mapped(map, 0.5)));
  else for (const t of [0, 0.25, 0.5, 0.75, 1]) child(ticks, "span", brief(valueOfColor(f, t)));
  draw();
}
// The value with the colour at a place of the bar.
function valueOfColor(f, t) {
  if (!f.isLogarithmic) return f.low * (1 - t) + f.high * t;
  return 10 ** (f.least10 + (f.greatest10 - f.least10) * t);
}
function showRange() {
  const f = shown, width = f.greatest - f.least;
  element("scale").style.display = f.isClass || f.isConstant ? "none" : "block";
  if (f.isConstant) range.value.set(-1, 1); // the colour in the middle
  else if (f.isLogarithmic) range.value.set(0, 1);
  else range.value.set((f.low - f.least) / width, (f.high - f.least) / width);
  element("low").value = brief(f.low);
  element("high").value = brief(f.high);
  element("low").disabled = element("high").disabled = f.isLogarithmic;
  element("logarithmic").disabled = !(f.greatest > 0);
  levels.value = Number(element("levels").value);
}
function showField() {
  const name = element("field").value, f = fields[name] || null;
  if (f) f.isLogarithmic = !f.isClass && !f.isConstant && f.greatest > 0 &&
    element("logarithmic").checked;
  if (f && f.isLogarithmic) takeLogarithms(f);
  if (f && f.isClass) {
    classify(f);
    drawClasses(f.numbers, strengths(f, fields.find(d => d.name === "distance")));
  }
  drawValues(f && (f.isLogarithmic ? f.logarithms : f.values));
  shown = f;
  kindOfColor.value = f ? f.isClass ? 3 : 2 : name === "faces" ? 1 : 0;
  if (f) showRange(); else element("scale").style.display = "none";
  const checks = texture.length > 0 && element("checks").checked;
  squares.value = checks ? reach[2] > 0 ? Math.min(12 / reach[2], 400) : 24 : 0;
  if (texture.length > 0) element("texture-label").style.display = "block";
  const isLight = !element("faces").checked || !f && name === "none"; // the page, or the faces
  for (const layer of layers.input)
    for (const part of layer.children) part.children[0].material.uniforms.rgb.value = isLight ? grey : white;
  showMap();
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
for (const name of ["levels", "checks", "logarithmic"])
  element(name).addEventListener("change", showField);
element("field").addEventListener("change", () => {
  element("logarithmic").checked = false;
  showField();
});
element("map").addEventListener("change", showMap);
element("plane-shown").addEventListener("change", resize);

// ---- How the surface is drawn ----
element("opacity").addEventListener("input", event => {
  opacity.value = Number(event.target.value);
  for (const view of views) {
    view.faces.material.transparent = opacity.value < 1;
    view.faces.material.depthWrite = opacity.value === 1;
  }
  draw();
});
let smooth = null;
function showSmooth() {
  if (element("smooth").checked && !smooth) smooth = smoothNormals();
  normalAttribute.array.set(element("smooth").checked ? smooth : flatNormal);
  normalAttribute.needsUpdate = true;
  draw();
}
element("smooth").checked = settings.edges !== "shown" && count < 1e6;
element("smooth").addEventListener("change", showSmooth);
element("axes").addEventListener("change", event => {
  element("triad").style.display = event.target.checked ? "block" : "none";
});
function fold(isFolded) {
  element("panel").classList.toggle("folded", isFolded);
  element("fold").textContent = isFolded ? "\u25b8" : "\u25be";
}
element("fold").addEventListener("click", () => {
  fold(!element("panel").classList.contains("folded"));
  resize();
});

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
  drawNow();
  const link = document.createElement("a");
  link.download = document.title.replace(/[^A-Za-z0-9._-]+/g, "_") + ".png";
  link.href = renderer.domElement.toDataURL("image/png");
  link.click();
});
window.addEventListener("resize", resize);
controls.addEventListener("change", draw);
fold(window.innerWidth < 600);
if (window.location.hash === "#picture") // alone
  for (const name of ["panel", "legend", "triad"]) element(name).style.visibility = "hidden";
showField();
showSheet();
showSmooth();
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
