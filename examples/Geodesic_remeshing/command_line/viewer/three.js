// What page.js uses of three.js; scripts/viewer makes three.min.js of it.
export {
  BufferAttribute,
  BufferGeometry,
  GLSL3,
  Mesh,
  PerspectiveCamera,
  Scene,
  ShaderMaterial,
  Vector3,
  WebGLRenderer
} from "three";
export { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
export { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
export { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
export { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
