R"page(// ---- Edges: each a rectangle on the screen, narrower where its faces are narrow ----
const size = new THREE.Vector2(1, 1), pixelsPerUnit = { value: 1 };
function edges(id, width, rgb, order) {
  const ends = decode(id, Uint32Array), room = decode(id + "-room", Float32Array);
  const beside = decode(id + "-sheets", Uint8Array);
  return views.map(view => {
    const group = new THREE.Group();
    for (const sheets of isCover ? [1, 2] : [0]) { // a part for fronts, and one for backs
      const all = [];
      const hasEnds = s => isFinite(view.point[3 * ends[2 * s]] + view.point[3 * ends[2 * s + 1]]);
      for (let s = 0; s < room.length; ++s)
        if ((!isCover || beside[s] & sheets) && hasEnds(s)) all.push(s);
      const start = new Float32Array(3 * all.length), end = new Float32Array(3 * all.length);
      all.forEach((s, k) => {
        for (let c = 0; c < 3; ++c) {
          start[3 * k + c] = view.point[3 * ends[2 * s] + c];
          end[3 * k + c] = view.point[3 * ends[2 * s + 1] + c];
        }
      });
      const narrow = Float32Array.from(all, s => view === surface ? room[s] : 1e6);
      group.add(lines(view, start, end, narrow,
        { width: view === surface ? width : 0.7 * width, rgb: rgb, order: order }));
    }
    view.scene.add(group);
    return group;
  });
}
// Lines from `start` to `end`, where there is `room`, with the widths `widths` times `width`, in
// the colour `rgb`, in the order `order`. With `cap` they are longer by half their width at both
// ends. Of an arrow head, `tip`, the width ends in a point. `ghost`: how opaque they are where
// something hides them.
function lines(view, start, end, room, o) {
  const g = new THREE.InstancedBufferGeometry();
  g.setAttribute("position", attribute(new Float32Array([0, -1, 0, 0, 1, 0, 1, -1, 0, 1, 1, 0])));
  g.setIndex([0, 1, 2, 2, 1, 3]);
  g.setAttribute("start", new THREE.InstancedBufferAttribute(start, 3));
  g.setAttribute("end", new THREE.InstancedBufferAttribute(end, 3));
  g.setAttribute("room", new THREE.InstancedBufferAttribute(room, 1));
  g.setAttribute("wide", new THREE.InstancedBufferAttribute(
    o.widths || new Float32Array(room.length).fill(1), 1));
  g.maxInstancedCount = room.length;
  const part = (opacity, isGhost) => {
    const material = new THREE.ShaderMaterial({ side: THREE.DoubleSide, transparent: true,
      depthWrite: false, depthTest: !isGhost, uniforms: { size: { value: size }, cut: view.cut,
        reach: view.ends, width: { value: o.width }, cap: { value: o.cap || 0 },
        tip: { value: o.tip ? 1 : 0 }, opacity: { value: opacity },
        rgb: { value: new THREE.Color(o.rgb) }, pixelsPerUnit: pixelsPerUnit }, vertexShader: `
      attribute vec3 start; attribute vec3 end; attribute float room; attribute float wide;
      varying vec3 x;
      uniform vec2 size; uniform float width; uniform float cap; uniform float pixelsPerUnit;
      uniform float tip;
      varying float cover;
      void main() {
        vec4 a = modelViewMatrix * vec4(start, 1.0), b = modelViewMatrix * vec4(end, 1.0);
        // cut what is behind the eye, where nothing can be projected
        float near = -0.0005;
        if (a.z > near && b.z < near) a = mix(b, a, (b.z - near) / (b.z - a.z));
        if (b.z > near && a.z < near) b = mix(a, b, (a.z - near) / (a.z - b.z));
        vec4 e = position.x < 0.5 ? a : b;
        float w = wide * clamp(0.2 * room * pixelsPerUnit / max(-e.z, 0.0005), 0.15 * width, width);
        x = mix(start, end, position.x);
        cover = min(w, 1.0); // what is narrower than a pixel is a pixel that is half transparent
        w = max(w, 1.0) * (1.0 - tip * position.x);
        a = projectionMatrix * a; b = projectionMatrix * b;
        vec2 d = (b.xy / b.w - a.xy / a.w) * size;
        d = length(d) > 1e-6 ? normalize(d) : vec2(1.0, 0.0);
        // nearer to the eye than the faces
        vec4 p = projectionMatrix * vec4(e.xyz * 0.9996, 1.0);
        p.xy += (vec2(-d.y, d.x) * position.y + d * (2.0 * position.x - 1.0) * cap) * w / size * p.w;
        gl_Position = p;
      }`, fragmentShader: `uniform vec3 rgb; varying float cover; varying vec3 x;
      uniform vec4 cut; uniform vec3 reach; uniform float opacity;
      void main() {
        if (dot(cut.xyz, x) > cut.w || reach.z > 0.0 && distance(x.xy, reach.xy) > reach.z) discard;
        gl_FragColor = vec4(rgb, cover * opacity); }` });
    const mesh = new THREE.Mesh(g, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = isGhost ? o.order + 10 : o.order;
    return mesh;
  };
  const all = new THREE.Group();
  all.add(part(1, false));
  if (o.ghost) all.add(part(o.ghost, true));
  return all;
}
const white = new THREE.Color(0xffffff), grey = new THREE.Color(0x7b8594);
const layers = { input: edges("input-edges", 0.9, 0xffffff, 1),
  intrinsic: edges("intrinsic-edges", 1.7, 0x10151d, 2) };

// ---- Curves: lines of full width, on top of edges, in a colour that their label chooses ----
// Where several run along the same line, each is wider than the next one above it: all of them show.
const palette = [0xe6194b, 0x0057e7, 0xf58231, 0x911eb4, 0x008080, 0xd900c8, 0x2e7d32, 0x8d5524,
  0x10151d]; // the last one of negative labels
// Both ends of each line of curves, and its label. The size of a closed curve is negative.
function segments(id) {
  const places = decode(id, Float32Array), sizes = decode(id + "-sizes", Int32Array);
  const labels = decode(id + "-labels", Int32Array);
  const lineCount = n => n < 0 ? -n : n - 1;
  const total = sizes.reduce((sum, n) => sum + lineCount(n), 0);
  const ends = new Float32Array(6 * total), label = new Int32Array(total);
  let first = 0, s = 0;
  sizes.forEach((n, c) => {
    const length = Math.abs(n), place = k => 3 * (first + k % length);
    for (let k = 0; k < lineCount(n); ++k, ++s) {
      ends.set(places.subarray(place(k), place(k) + 3), 6 * s);
      ends.set(places.subarray(place(k + 1), place(k + 1) + 3), 6 * s + 3);
      label[s] = labels[c];
    }
    first += length;
  });
  return { ends: ends, label: label };
}
// What is hidden of curves shines through.
const curveSets = [["initial-curves", 2, [0x5a616c], 3, 0],
  ["curves", Number(settings.curveWidth), palette, 4, 0.22]].map(([id, width, colors, order, ghost]) =>
  ({ id: id, width: width, colors: colors, order: order, ghost: ghost, ...segments(id) }));
const above = new Map(); // how many curves have been counted on each line, from the topmost one
function lineName(set, s) {
  const name = k => [0, 1, 2].map(c => Math.round(2e5 * set.ends[6 * s + 3 * k + c])).join();
  return [name(0), name(1)].sort().join(";");
}
for (const set of curveSets.slice().reverse()) {
  const last = set.colors.length - 1;
  const colorOf = s => set.label[s] < 0 ? last : set.label[s] % Math.max(last, 1);
  set.widths = new Float32Array(set.label.length);
  set.byColor = set.colors.map(() => []);
  for (const s of set.label.keys()) set.byColor[colorOf(s)].push(s);
  set.widths.fill(1);
  if (set.label.length > 2e5) continue; // too many to be compared
  set.colors.map((_, i) => i).reverse().forEach(i => {
    for (const s of set.byColor[i]) {
      const name = lineName(set, s), others = above.get(name) || new Set();
      set.widths[s] = 1 + 0.9 * others.size * Number(settings.curveWidth) / set.width;
      above.set(name, others);
    }
    for (const s of set.byColor[i]) above.get(lineName(set, s)).add(set.id + i);
  });
}
for (const set of curveSets) {
  const group = new THREE.Group();
  set.byColor.forEach((all, i) => {
    const start = new Float32Array(3 * all.length), end = new Float32Array(3 * all.length);
    all.forEach((s, k) => {
      start.set(set.ends.subarray(6 * s, 6 * s + 3), 3 * k);
      end.set(set.ends.subarray(6 * s + 3, 6 * s + 6), 3 * k);
    });
    if (all.length > 0)
      group.add(lines(surface, start, end, new Float32Array(all.length).fill(1e6),
        { width: set.width, rgb: set.colors[i], order: set.order, cap: 1,
          widths: Float32Array.from(all, s => set.widths[s]), ghost: set.ghost }));
  });
  scene.add(group);
  if (set.label.length > 0) element(set.id + "-label").style.display = "block";
  element(set.id + "-shown").addEventListener("change", event => {
    group.visible = event.target.checked;
    draw();
  });
}

// ---- Marked points: discs, in a colour that the sign of their label chooses ----
const mark = decode("marks", Float32Array), markLabel = decode("marks-labels", Int32Array);
const markColor = l => l > 0 ? [0.84, 0.1, 0.11] : l < 0 ? [0.13, 0.4, 0.85] : [1, 0.8, 0];
if (markLabel.length > 0) {
  const g = new THREE.BufferGeometry();
  g.setAttribute("position", attribute(mark));
  g.setAttribute("color", attribute(Float32Array.from([].concat(
    ...Array.from(markLabel, markColor)))));
  const discs = (opacity, isGhost) => new THREE.Points(g, new THREE.ShaderMaterial({ transparent: true,
    depthTest: !isGhost, depthWrite: !isGhost, uniforms: { cut: cut, opacity: { value: opacity },
      size: { value: 15 * window.devicePixelRatio } }, vertexShader: `
    attribute vec3 color; varying vec3 c; varying vec3 x; uniform float size;
    void main() { c = color; x = position; gl_PointSize = size;
      // nearer to the eye than the faces around
      gl_Position = projectionMatrix * vec4((modelViewMatrix * vec4(position, 1.0)).xyz * 0.994, 1.0); }`,
    fragmentShader: `varying vec3 c; varying vec3 x; uniform vec4 cut; uniform float opacity;
    void main() { float r = 2.0 * length(gl_PointCoord - 0.5);
      if (r > 1.0 || dot(cut.xyz, x) > cut.w) discard;
      gl_FragColor = vec4(r > 0.72 ? vec3(0.1, 0.12, 0.16) : c, opacity); }` }));
  const marks = new THREE.Group();
  marks.add(discs(1, false));
  if (markLabel.length <= 500) marks.add(discs(0.3, true)); // what is hidden shines through
  marks.children.forEach((part, i) => {
    part.frustumCulled = false;
    part.renderOrder = i === 0 ? 5 : 15;
  });
  scene.add(marks);
  const counts = new Map();
  for (const l of markLabel) counts.set(l, (counts.get(l) || 0) + 1);
  element("marks-text").textContent = settings.marks + ": " + ([...counts.keys()].join() === "0" ?
    markLabel.length : [...counts].sort((a, b) => b[0] - a[0]).map(([l, n]) =>
      n + " of index " + (l > 0 ? "+" : "") + l).join(", "));
  element("marks-label").style.display = "block";
  element("marks-shown").addEventListener("change", event => {
    marks.visible = event.target.checked;
    draw();
  });
}

// ---- Vectors at points: arrows, or lines of crosses ----
const glyph = { place: decode("glyph-places", Float32Array), vector: decode("glyph-vectors", Float32Array),
  group: new THREE.Group(), size: 1 };
// The numbers of vectors whose places are the first ones in a cell of a grid, with all others there
// at the same place.
function glyphsApart(cell) {
  const first = new Map(), all = [];
  for (let i = 0; i < glyph.place.length; i += 3) {
    const [x, y, z] = glyph.place.subarray(i, i + 3);
    const name = [x, y, z].map(t => Math.floor(t / cell)).join(), here = first.get(name);
    if (here === undefined) first.set(name, i);
    if (here === undefined || x === glyph.place[here] && y === glyph.place[here + 1] &&
      z === glyph.place[here + 2]) all.push(i);
  }
  return all;
}
// The longest vector is as long as half a mean edge, but at least long enough to be seen.
function drawGlyphs(factor) {
  const longest = Number(settings.glyphLength), length = Math.max(longest, 0.022) * factor;
  const all = length > 1.3 * longest ? glyphsApart(1.6 * length) :
    Array.from({ length: glyph.place.length / 3 }, (_, k) => 3 * k);
  const isArrow = settings.glyphs === "arrows", neck = isArrow ? 0.62 : 1, scale = length / longest;
  const at = part => Float32Array.from({ length: 3 * all.length }, (_, k) => {
    const i = all[Math.floor(k / 3)] + k % 3;
    return glyph.place[i] + part * scale * glyph.vector[i];
  });
  const room = new Float32Array(all.length).fill(1e6), middle = at(neck), o = { rgb: 0x10151d, order: 4 };
  for (const part of glyph.group.children.slice()) {
    part.children[0].geometry.dispose();
    glyph.group.remove(part);
  }
  glyph.group.add(lines(surface, at(0), middle, room, { width: 1.3, ...o }));
  if (isArrow) glyph.group.add(lines(surface, middle, at(1), room, { width: 4.5, tip: true, ...o }));
}
if (glyph.place.length > 0) {
  scene.add(glyph.group);
  drawGlyphs(1);
  element("glyphs-text").textContent = settings.glyphs;
  element("glyphs-row").style.display = "flex";
  element("glyphs-shown").addEventListener("change", event => {
    glyph.group.visible = event.target.checked;
    draw();
  });
  element("glyph-size").addEventListener("input", event => {
    drawGlyphs(Math.exp(Number(event.target.value) * Math.LN2));
    draw();
  });
}

)page"
