export {
    Box3, BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, PerspectiveCamera, Quaternion, SRGBColorSpace, Scene,
    ShaderMaterial, Spherical, Vector3, WebGLRenderTarget, WebGLRenderer
} from 'three';
export {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
