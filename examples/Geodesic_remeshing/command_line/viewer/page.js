// The page of geodesic_remesh --html: draws what report and meshes the element "data" holds. The program makes that element; its
// arrays are base64 of little-endian numbers. The part behind # in the address sets the view: #color=angle&edges=0&up=z
"use strict";
(() => {

const data = JSON.parse(document.getElementById("data").textContent);
const report = data.report;
const element = id => document.getElementById(id);
const number = (value, digits = 0) =>
  value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});

function make(tag, attributes = {}, ...children) {
  const isGraphic = ["svg", "g", "rect", "line", "path", "text", "title"].includes(tag);
  const made = isGraphic ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function decode(text, Type) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Type(bytes.buffer);
}

// ---- words and figures

function showTitle() {
  document.title = `${data.title}: remeshed`;
  element("title").append(data.title, make("span", {class: "arrow"}, "→"), `${number(report.output.vertices)} vertices`);
  const seconds = report.seconds.total;
  element("subtitle").textContent =
    `${number(report.regions)} regions, ${number(report.curves)} curves, ${number(report.strips)} strips; ` +
    `edges ${report.edge_length.toPrecision(4)} long; ${number(seconds, seconds < 10 ? 2 : 0)} s`;
  element("footer").textContent = `Made by geodesic_remesh ${report.version}. Angles in degrees; distances in percent of the ` +
    `diagonal of the bounding box of the input, sampled in both directions (Hausdorff) or from the input to the output (RMS).`;
}

function showTiles() {
  const tile = (name, value, unit, was) => element("tiles").append(make("div", {class: "tile"},
    make("div", {class: "name"}, name),
    make("div", {class: "value"}, value, make("span", {class: "unit"}, unit)),
    make("div", {class: "was"}, was)));
  const {input, output} = report;
  tile("Vertices", number(output.vertices), "", `from ${number(input.vertices)}`);
  tile("Smallest angle", number(output.min_angle, 1), "°", `from ${number(input.min_angle, 1)}°`);
  tile("Mean smallest angle", number(output.mean_min_angle, 1), "°", `from ${number(input.mean_min_angle, 1)}°`);
  tile("Faces below 30°", number(output.percent_below_30, 2), " %", `from ${number(input.percent_below_30, 1)} %`);
  tile("Irregular vertices", number(output.percent_irregular, 1), " %", `from ${number(input.percent_irregular, 1)} %`);
  tile("Hausdorff distance", number(output.hausdorff_percent, 3), " %", `RMS ${number(output.rms_percent, 4)} %`);
}

function showQuality() {
  const rows = [["Vertices", "vertices", 0], ["Faces", "faces", 0], ["Components", "components", 0], ["Genus", "genus", 0],
    ["Boundary loops", "boundary_loops", 0], ["Smallest angle, °", "min_angle", 2], ["Mean smallest angle, °", "mean_min_angle", 2],
    ["Faces with an angle below 30°, %", "percent_below_30", 3], ["Irregular vertices, %", "percent_irregular", 2],
    ["Faces with an angle below 20°", "faces_below_20", 0], ["Of these between lines", "faces_below_20_between_lines", 0],
    ["Hausdorff distance, %", "hausdorff_percent", 4], ["RMS distance, %", "rms_percent", 4]];
  const cell = (side, key, digits) => make("td", {}, key in report[side] ? number(report[side][key], digits) : "");
  element("quality").append(
    make("thead", {}, make("tr", {}, make("th"), make("th", {}, "input"), make("th", {}, "output"))),
    make("tbody", {}, ...rows.map(([name, key, digits]) =>
      make("tr", {}, make("th", {scope: "row"}, name), cell("input", key, digits), cell("output", key, digits)))));
}

function showStages() {
  const stages = Object.entries(report.seconds).filter(([name]) => name !== "total");
  const longest = Math.max(...stages.map(([, seconds]) => seconds), 1e-9);
  for (const [name, seconds] of stages)
    element("stages").append(make("div", {class: "stage"}, make("span", {}, name),
      make("div", {class: "track"}, make("div", {class: "fill", style: `width:${100 * seconds / longest}%`})),
      make("span", {class: "seconds"}, number(seconds, 3))));
  element("stages").append(make("div", {class: "stage total"}, make("span", {}, "in all"), make("span"),
    make("span", {class: "seconds"}, number(report.seconds.total, 3))));
}

function showCheck() {
  const check = report.check;
  if (!check)
    return;
  element("check").hidden = false;
  const item = (holds, text) => element("checks").append(make("li", holds ? {} : {class: "fails"}, text));
  item(check.manifold, "a manifold triangle mesh");
  item(check.same_components && check.same_genus && check.same_boundary_loops, "the components, handles and boundary loops of the input");
  item(check.number_of_vertices, "the number of vertices asked for");
  item(check.degenerate_faces === 0, `${number(check.degenerate_faces)} faces without area`);
  item(check.flipped_faces === 0, `${number(check.flipped_faces)} faces turned against the input`);
  item(check.self_intersections === 0 || check.input_intersects_itself, `${number(check.self_intersections)} self-intersections` +
    (check.input_intersects_itself ? "; the input has some itself" : ""));
}

// ---- charts

const chart = {width: 560, height: 230, left: 40, right: 8, top: 10, bottom: 26};

function axes(highest, digits) {
  const {width, height, left, right, top, bottom} = chart;
  const svg = make("svg", {viewBox: `0 0 ${width} ${height}`, role: "img"});
  const y = value => height - bottom - (height - top - bottom) * value / highest;
  for (let i = 0; i <= 4; ++i) {
    const value = highest * i / 4;
    svg.append(make("line", {class: "grid", x1: left, x2: width - right, y1: y(value), y2: y(value)}),
      make("text", {x: left - 6, y: y(value) + 4, "text-anchor": "end"}, `${number(value, digits)} %`));
  }
  return {svg, y};
}

function key() {
  return make("div", {class: "key"}, make("span", {}, "input"), make("span", {class: "is-after"}, "output"));
}

const percents = counts => {
  const sum = counts.reduce((a, b) => a + b, 0) || 1;
  return counts.map(count => 100 * count / sum);
};
const rounded = value => [1, 2, 4, 6, 8, 10, 12, 16, 20, 24, 32, 40, 60, 80].find(step => value <= step) || 100;

// Two curves over 0 to 180 degrees
function showAngles() {
  const before = percents(data.histograms.angles.input), after = percents(data.histograms.angles.output);
  const highest = rounded(Math.max(...before, ...after));
  const {svg, y} = axes(highest, highest < 4 ? 1 : 0);
  const x = i => chart.left + (chart.width - chart.left - chart.right) * i / after.length;
  for (const degrees of [0, 30, 60, 90, 120, 150, 180]) {
    const at = x(degrees / 180 * after.length);
    svg.append(make("line", {class: "grid", x1: at, x2: at, y1: chart.top, y2: chart.height - chart.bottom}),
      make("text", {x: at, y: chart.height - 8, "text-anchor": "middle"}, `${degrees}°`));
  }
  const steps = values => values.map((value, i) => `L${x(i)} ${y(value)}H${x(i + 1)}`).join("");
  const outline = values => `M${x(0)} ${y(0)}${steps(values)}L${x(values.length)} ${y(0)}`;
  svg.append(make("path", {class: "area", d: outline(after) + "Z"}), make("path", {class: "line-before", d: outline(before)}),
    make("path", {class: "line-after", d: outline(after)}));
  element("chart-angles").append(svg, key());
}

// Pairs of bars: 3 to 9, and 10 and more
function showValences() {
  const before = percents(data.histograms.valences.input), after = percents(data.histograms.valences.output);
  const {svg, y} = axes(rounded(Math.max(...before, ...after)), 0);
  const step = (chart.width - chart.left - chart.right) / after.length;
  after.forEach((value, i) => {
    const middle = chart.left + step * (i + .5), name = `${i + 3}${i + 1 === after.length ? "+" : ""}`;
    const bar = (kind, percent, x) => svg.append(make("rect", {class: kind, x, y: y(percent), width: step * .34, rx: 2,
      height: Math.max(0, y(0) - y(percent))}, make("title", {}, `${number(percent, 2)} % have ${name} neighbors`)));
    bar("before", before[i], middle - step * .36);
    bar("after", value, middle + step * .02);
    svg.append(make("text", {x: middle, y: chart.height - 8, "text-anchor": "middle"}, name));
  });
  element("chart-valences").append(svg, key());
}

// ---- colors

const plainColor = [0.84, 0.86, 0.88];
const scales = {
  bad: [[0.75, 0.12, 0.15], [0.93, 0.49, 0.20], [0.98, 0.85, 0.45], [0.55, 0.80, 0.62], [0.10, 0.55, 0.55]],
  far: [[0.95, 0.95, 0.92], [0.99, 0.82, 0.50], [0.95, 0.50, 0.30], [0.74, 0.17, 0.38], [0.33, 0.06, 0.42]]
};
const regionColors = data.region_colors.map(color => color.map(c => c / 255));

function onScale(scale, value) {
  const t = Math.min(Math.max(value, 0), 1) * (scale.length - 1);
  const i = Math.min(Math.floor(t), scale.length - 2);
  return scale[i].map((c, k) => c + (scale[i + 1][k] - c) * (t - i));
}

const css = color => `rgb(${color.map(c => Math.round(255 * c)).join(" ")})`;
const gradient = scale => make("span", {class: "bar", style: `background:linear-gradient(90deg, ${scale.map(css).join(", ")})`});
const dot = (color, text) => make("span", {}, make("span", {class: "dot", style: `background:${css(color)}`}), text);
const valenceColor = {low: [0.89, 0.36, 0.18], regular: plainColor, high: [0.16, 0.40, 0.75]};

// For each way to color: its name, what there is of a face (or of its corners) as a color, and its legend
const colorings = {
  plain: {name: "Plain", face: () => plainColor, legend: []},
  angle: {name: "Smallest angle", face: (mesh, f) => onScale(scales.bad, mesh.angle[f] / 240),
    legend: ["0°", gradient(scales.bad), "60°"]},
  quality: {name: "Quality", face: (mesh, f) => onScale(scales.bad, mesh.quality[f] / 255),
    legend: ["0", gradient(scales.bad), "1: equilateral (twice the radius of the incircle by that of the circumcircle)"]},
  valence: {name: "Valence", corner: (mesh, v) => mesh.valence[v] === 0 || mesh.valence[v] === 6 ? valenceColor.regular
    : mesh.valence[v] < 6 ? valenceColor.low : valenceColor.high,
    legend: [dot(valenceColor.low, "5 or fewer"), dot(valenceColor.regular, "6"), dot(valenceColor.high, "7 or more")]},
  deviation: {name: "Deviation", face: (mesh, f) => onScale(scales.far, mesh.deviation[f] / 255),
    legend: ["0", gradient(scales.far), `${data.largest_deviation.toPrecision(2)} % of the diagonal`]},
  regions: {name: "Regions", face: (mesh, f) => mesh.region ? regionColors[mesh.region[f] % regionColors.length] : plainColor,
    legend: [`${number(report.regions)} regions around their tops`]}
};

// ---- meshes

const vertexShader = `
  in vec3 color;
  out vec3 v_color, v_view, v_normal, v_corner;
  void main() {
    int corner = gl_VertexID % 3;
    v_corner = vec3(corner == 0, corner == 1, corner == 2);
    v_color = color;
    v_normal = normalMatrix * normal;
    vec4 view = modelViewMatrix * vec4(position, 1.);
    v_view = view.xyz;
    gl_Position = projectionMatrix * view;
  }`;
const fragmentShader = `
  in vec3 v_color, v_view, v_normal, v_corner;
  out vec4 color;
  uniform float edges, smoothness;
  void main() {
    vec3 flat_normal = normalize(cross(dFdx(v_view), dFdy(v_view)));
    vec3 normal = normalize(gl_FrontFacing ? v_normal : -v_normal);
    normal = smoothness > 0. && dot(normal, flat_normal) > 0. ? normal : flat_normal;
    float key = max(dot(normal, normalize(vec3(.35, .55, .75))), 0.), fill = max(dot(normal, normalize(vec3(-.7, -.1, .6))), 0.);
    float shine = pow(max(dot(normal, normalize(vec3(.2, .35, 1.))), 0.), 40.);
    vec3 base = gl_FrontFacing ? v_color : mix(v_color, vec3(.45, .3, .3), .6);
    vec3 lit = base * (.44 + .6 * key + .14 * fill) + .06 * shine;
    vec3 width = fwidth(v_corner);
    vec3 near = smoothstep(width * .15, width * 1.05, v_corner);
    float line = 1. - min(min(near.x, near.y), near.z);
    float size = max(max(width.x, width.y), width.z); // where triangles are as small as pixels lines would only blacken
    color = vec4(mix(lit, lit * .3, edges * line * (1. - smoothstep(.1, .36, size))), 1.);
  }`;

function readMesh(encoded) {
  const mesh = {shown: encoded.shown, faces: encoded.faces, positions: decode(encoded.positions, Float32Array),
    indices: decode(encoded.indices, Uint32Array)};
  for (const name of ["angle", "quality", "deviation", "valence"])
    mesh[name] = decode(encoded[name], Uint8Array);
  if (encoded.region)
    mesh.region = decode(encoded.region, Uint16Array);
  return mesh;
}

// The normal of each vertex, weighted by area
function vertexNormals({positions: p, indices}) {
  const normals = new Float32Array(p.length);
  for (let i = 0; i < indices.length; i += 3) {
    const a = 3 * indices[i], b = 3 * indices[i + 1], c = 3 * indices[i + 2];
    const u = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]], v = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const at of [a, b, c])
      for (let k = 0; k < 3; ++k)
        normals[at + k] += n[k];
  }
  return normals;
}

// Each face has corners of its own, so that it can have a color of its own
function geometryOf(mesh) {
  const {positions, indices} = mesh, normals = vertexNormals(mesh);
  const corners = new Float32Array(3 * indices.length), directions = new Int16Array(3 * indices.length);
  indices.forEach((v, i) => {
    const length = Math.hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]) || 1;
    for (let k = 0; k < 3; ++k) {
      corners[3 * i + k] = positions[3 * v + k];
      directions[3 * i + k] = Math.round(32767 * normals[3 * v + k] / length);
    }
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(directions, 3, true));
  geometry.setAttribute("color", new THREE.BufferAttribute(new Uint8Array(3 * indices.length), 3, true));
  return geometry;
}

function paint(object, coloring) {
  const {mesh, geometry} = object, colors = geometry.getAttribute("color");
  for (let i = 0; i < mesh.indices.length; ++i) {
    const color = coloring.corner ? coloring.corner(mesh, mesh.indices[i]) : i % 3 === 0 ? coloring.face(mesh, i / 3) : null;
    for (let k = 0; k < 3; ++k)
      colors.array[3 * i + k] = color ? Math.round(255 * color[k]) : colors.array[3 * i + k - 3];
  }
  colors.needsUpdate = true;
}

function curvesOf(encoded) {
  const points = decode(encoded.points, Float32Array), sizes = decode(encoded.sizes, Uint32Array);
  const ends = [];
  let at = 0;
  for (const size of sizes) {
    for (let i = 0; i + 1 < size; ++i)
      ends.push(...points.subarray(3 * (at + i), 3 * (at + i) + 6));
    at += size;
  }
  return new THREE.LineSegmentsGeometry().setPositions(new Float32Array(ends));
}

// ---- the view

const state = {color: "plain", edges: true, smooth: false, curves: false, up: "y"};
for (const [name, value] of new URLSearchParams(location.hash.slice(1)))
  if (name in state)
    state[name] = typeof state[name] === "boolean" ? value !== "0" : value;
if (!(state.color in colorings))
  state.color = "plain";

class Viewer {
  constructor() {
    this.canvas = element("canvas");
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true});
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setScissorTest(true);
    this.material = new THREE.ShaderMaterial({vertexShader, fragmentShader, glslVersion: THREE.GLSL3, side: 2,
      uniforms: {edges: {value: 1}, smoothness: {value: 0}}, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.lineMaterial = new THREE.LineMaterial({color: 0x26323f, linewidth: 1.7, worldUnits: false});
    this.camera = new THREE.PerspectiveCamera(30, 1, .01, 100);
    this.controls = new THREE.TrackballControls(this.camera, this.canvas);
    Object.assign(this.controls, {rotateSpeed: 3, zoomSpeed: 1.4, panSpeed: .5, dynamicDampingFactor: .16, minDistance: .2, maxDistance: 20});
    this.controls.addEventListener("change", () => { this.isOld = true; });
    this.objects = Object.fromEntries(Object.entries(data.meshes).map(([name, encoded]) => [name, this.objectOf(readMesh(encoded))]));
    this.curves = data.curves ? new THREE.LineSegments2(curvesOf(data.curves), this.lineMaterial) : null;
    this.scene = new THREE.Scene();
    new ResizeObserver(() => this.resize()).observe(element("views"));
    this.resize();
    this.resetCamera();
    this.frame = this.frame.bind(this);
  }

  objectOf(mesh) {
    const geometry = geometryOf(mesh);
    const shown = new THREE.Mesh(geometry, this.material);
    shown.frustumCulled = false;
    return {mesh, geometry, shown, coloring: null};
  }

  resize() {
    const {clientWidth, clientHeight} = element("views");
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.controls.handleResize();
    this.isOld = true;
  }

  // In front of it, a little from the side and from above
  resetCamera() {
    const up = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]}[state.up] || [0, 1, 0];
    const shift = v => [v[2], v[0], v[1]];
    const front = shift(up), side = shift(front); // up y: front z, side x
    const offset = up.map((u, k) => .30 * u + .85 * front[k] + .45 * side[k]);
    const length = Math.hypot(...offset);
    this.controls.target.set(0, 0, 0);
    this.camera.up.set(...up);
    this.camera.position.set(...offset.map(c => 3.5 * c / length));
    this.camera.lookAt(0, 0, 0);
    this.isOld = true;
  }

  apply() {
    this.material.uniforms.edges.value = state.edges ? .72 : 0;
    this.material.uniforms.smoothness.value = state.smooth ? 1 : 0;
    this.isOld = true;
  }

  // the input is cut along the boundaries of the regions where these are shown
  object(side) {
    return side === "input" && state.color === "regions" && this.objects.regions ? this.objects.regions : this.objects[side];
  }

  draw(side, x, y, width, height) {
    const object = this.object(side);
    if (object.coloring !== state.color) {
      paint(object, colorings[state.color]);
      object.coloring = state.color;
    }
    this.scene.clear();
    this.scene.add(object.shown);
    if (this.curves && state.curves)
      this.scene.add(this.curves);
    this.renderer.setViewport(x, y, width, height);
    this.renderer.setScissor(x, y, width, height);
    this.lineMaterial.resolution.set(width, height);
    this.camera.aspect = width / height;
    this.camera.fov = width < height ? 2 * Math.atan(Math.tan(15 * Math.PI / 180) * height / width) * 180 / Math.PI : 30;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    return this.renderer.info.render.triangles;
  }

  frame() {
    this.controls.update();
    if (this.isOld) {
      this.isOld = false;
      const {clientWidth: width, clientHeight: height} = element("views");
      const isStacked = getComputedStyle(element("views")).flexDirection === "column";
      const w = isStacked ? width : width / 2, h = isStacked ? height / 2 : height;
      const left = this.draw("input", 0, isStacked ? h : 0, w, h);
      const right = this.draw("output", isStacked ? 0 : w, 0, w, h);
      document.body.dataset.drawn = `${left} ${right}`; // for tests
    }
    requestAnimationFrame(this.frame);
  }
}

function showLabels(viewer) {
  for (const side of ["input", "output"]) {
    const {shown, faces} = viewer.object(side).mesh;
    const what = side === "input" && state.color === "regions" ? "Input, cut into regions" : side === "input" ? "Input" : "Output";
    element(`label-${side}`).textContent =
      `${what} · ${number(faces)} faces` + (shown < faces ? `, drawn with ${number(shown)}` : "");
  }
  element("legend").replaceChildren(...colorings[state.color].legend);
}

function showToolbar(viewer) {
  const update = () => {
    viewer.apply();
    showLabels(viewer);
    for (const button of element("toolbar").querySelectorAll("button[data-color]"))
      button.setAttribute("aria-checked", button.dataset.color === state.color);
    for (const button of element("toolbar").querySelectorAll("button[data-switch]"))
      button.setAttribute("aria-pressed", state[button.dataset.switch]);
  };
  const button = (parent, attributes, text, action) => {
    const made = make("button", {type: "button", ...attributes}, text);
    made.addEventListener("click", () => { action(made); update(); });
    element(parent).append(made);
  };
  for (const [name, coloring] of Object.entries(colorings))
    if (name !== "regions" || viewer.objects.regions)
      button("colors", {role: "radio", "data-color": name}, coloring.name, () => { state.color = name; });
  const names = {edges: "Edges", smooth: "Smooth", ...(viewer.curves ? {curves: "Curves"} : {})};
  for (const [name, text] of Object.entries(names))
    button("switches", {"data-switch": name}, text, () => { state[name] = !state[name]; });
  button("switches", {title: "which axis points upwards"}, `Up: ${state.up.toUpperCase()}`, made => {
    state.up = {x: "y", y: "z", z: "x"}[state.up] || "y";
    made.textContent = `Up: ${state.up.toUpperCase()}`;
    viewer.resetCamera();
  });
  button("switches", {}, "Reset view", () => viewer.resetCamera());
  update();
}

showTitle();
showTiles();
showQuality();
showStages();
showCheck();
showAngles();
showValences();
try {
  const viewer = new Viewer();
  showToolbar(viewer);
  viewer.frame();
} catch (error) {
  element("failure").hidden = false;
  element("toolbar").hidden = true;
  console.error(error);
  document.body.dataset.drawn = "";
}

})();
