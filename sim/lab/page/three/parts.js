export {
    Box3, BufferAttribute, BufferGeometry, ColorManagement, DirectionalLight, DoubleSide, HemisphereLight, LinearSRGBColorSpace,
    Mesh, MeshBasicMaterial, MeshPhongMaterial, PerspectiveCamera, Quaternion, Scene, Spherical, Vector3, WebGLRenderer
} from 'three';
export {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
