R"page(// ---- Colours ----
// viridis and inferno (S. van der Walt, N. Smith), cool to warm (K. Moreland), at places of equal distance
const maps = {
  viridis: [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141],
    [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]],
  inferno: [[0, 0, 4], [40, 11, 84], [101, 21, 110], [159, 42, 99], [212, 72, 66], [245, 125, 21],
    [250, 193, 39], [252, 255, 164]],
  "cool-warm": [[59, 76, 192], [124, 159, 249], [192, 212, 245], [221, 221, 221], [244, 196, 173],
    [238, 132, 104], [180, 4, 38]],
  cyclic: [[150, 60, 130], [60, 90, 190], [60, 170, 150], [200, 190, 70], [210, 100, 60],
    [150, 60, 130]],
  grey: [[25, 25, 25], [245, 245, 245]]
};
function mapped(map, x) {
  const last = map.length - 1, y = x * last, i = Math.min(Math.floor(y), last - 1), f = y - i;
  return [0, 1, 2].map(c => Math.round(map[i][c] * (1 - f) + map[i + 1][c] * f));
}
const mapTexture = new THREE.DataTexture(new Uint8Array(4 * 256), 256, 1, THREE.RGBAFormat);
mapTexture.magFilter = mapTexture.minFilter = THREE.LinearFilter;
// Classes: colours that differ in hue, then the same lighter and darker.
const hues = [[86, 160, 211], [240, 150, 60], [110, 190, 105], [225, 95, 95], [165, 130, 205],
  [175, 130, 105], [235, 150, 205], [150, 155, 160], [205, 200, 80], [75, 195, 205]];
function classColor(i) {
  const towards = [255, 60, 190][Math.floor(i / hues.length) % 3];
  const part = i < hues.length ? 0 : 0.4;
  return hues[i % hues.length].map(x => Math.round(x * (1 - part) + towards * part));
}
const css = rgb => "rgb(" + rgb.join() + ")";
// The classes of a field in order, and the number of that of each vertex; -1: none.
function classify(f) {
  if (f.classes) return;
  f.labels = Array.from(f.values, (x, v) => isFinite(x) ? Math.round(valueAt(f, v)) : null);
  f.classes = [...new Set(f.labels)].filter(x => x !== null).sort((a, b) => a - b);
  const number = new Map(f.classes.map((x, i) => [x, i]));
  f.numbers = f.labels.map(x => x === null ? -1 : number.get(x));
}
// Logarithms to the base 10, scaled to lie from 0 to 1; none of what is not positive.
function takeLogarithms(f) {
  if (f.logarithms) return;
  const all = Float64Array.from(f.values, (_, v) => {
    const x = valueAt(f, v);
    return x > 1e-12 * f.greatest ? Math.log10(x) : NaN;
  });
  const known = all.filter(isFinite);
  f.least10 = known.reduce((a, b) => Math.min(a, b), Infinity);
  f.greatest10 = known.reduce((a, b) => Math.max(a, b), -Infinity);
  const width = f.greatest10 - f.least10;
  f.logarithms = Float32Array.from(all, x => width > 0 ? (x - f.least10) / width : 0);
}

// How strong the class of each corner of a triangle is at each of its corners: 1 at its own, 0 at
// others. If there are distances, as of cells, then minus the distance from the source of the cell,
// which goes on linearly beyond it: so the line between cells is where distances are equal.
function strengths(f, distance) {
  const result = new Float32Array(9 * count), k = f.numbers, d = distance && distance.values;
  const slope = d && slopes(k, d);
  for (let i = 0; i < 9 * count; ++i) {
    const t = 3 * Math.floor(i / 9), j = triangle[t + Math.floor(i % 9 / 3)], m = triangle[t + i % 3];
    if (!d) result[i] = j === m || k[j] === k[m] ? 1 : 0;
    else if (k[j] === k[m]) result[i] = -d[j];
    else
      result[i] = [0, 1, 2].reduce((sum, c) =>
        sum - slope[3 * m + c] * (point[3 * j + c] - point[3 * m + c]), -d[m]);
  }
  return result;
}
// The gradient of a function at each vertex: that in the triangles around which are in its class.
function slopes(k, d) {
  const sum = new Float64Array(point.length), area = new Float64Array(k.length);
  for (let t = 0; t < 3 * count; t += 3) {
    const v = triangle.subarray(t, t + 3);
    if (k[v[0]] !== k[v[1]] || k[v[1]] !== k[v[2]]) continue;
    const p = Array.from(v, i => new THREE.Vector3().fromArray(point, 3 * i));
    const n = p[1].clone().sub(p[0]).cross(p[2].clone().sub(p[0])), twice = n.length();
    if (!(twice > 0)) continue;
    const g = new THREE.Vector3(); // times twice the area
    for (const c of [0, 1, 2])
      g.addScaledVector(n.clone().cross(p[(c + 2) % 3].clone().sub(p[(c + 1) % 3])), d[v[c]] / twice);
    for (const i of v) {
      area[i] += twice;
      [g.x, g.y, g.z].forEach((x, c) => { sum[3 * i + c] += x; });
    }
  }
  return sum.map((x, i) => area[Math.floor(i / 3)] > 0 ? x / area[Math.floor(i / 3)] : 0);
}

)page"
