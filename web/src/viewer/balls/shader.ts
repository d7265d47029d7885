/**
 * Shaders that draw balls as exact spheres. A square that covers the ball is drawn for each; every pixel
 * intersects its ray with the sphere. So edges are smooth at every size without triangles, and labels,
 * stripes and dots are computed from the direction on the ball.
 */

/** What the vertex shaders read: a square from −1 to 1, and a ball per instance. */
const INSTANCE = `
  /** Centre and radius, m; the radius of a hidden ball is zero. */
  in vec4 ball;
  /** Orientation as a quaternion, from the ball's axes to the table's. */
  in vec4 turn;
  /** Colour of the body and, in w, the cell of the label; below zero: none. */
  in vec4 body;
  /** Colour of the dots and, in w, 1: striped, 2: dots. */
  in vec4 extra;
`;

export const VERTEX = `
  ${INSTANCE}
  /** Pixels per unit of length at distance one. */
  uniform float pixels;
  out vec3 vOffset;
  flat out vec4 vBall;
  flat out vec4 vTurn;
  flat out vec4 vBody;
  flat out vec4 vExtra;

  void main() {
    vec3 center = (viewMatrix * vec4(ball.xyz, 1.0)).xyz;
    float distance = length(center);
    vec3 out_ = -center / distance;
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), out_));
    vec3 up = cross(out_, right);
    // The cone around the sphere is wider than the sphere at its centre. Add a pixel for the smooth edge.
    float cone = ball.w * distance * inversesqrt(max(distance * distance - ball.w * ball.w, 1e-6));
    float half_ = cone + 1.5 * distance / pixels;
    vOffset = half_ * (position.x * right + position.y * up);
    vBall = vec4(center, ball.w);
    vTurn = turn;
    vBody = body;
    vExtra = extra;
    gl_Position = projectionMatrix * vec4(center + vOffset, 1.0);
    if (ball.w == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
`;

export const FRAGMENT = `
  uniform float pixels;
  uniform sampler2D labels;
  uniform float cells;
  uniform vec3 sky;
  uniform vec3 ground;
  uniform vec3 lamp;
  /** Direction to the lamp. */
  uniform vec3 toLamp;
  in vec3 vOffset;
  flat in vec4 vBall;
  flat in vec4 vTurn;
  flat in vec4 vBody;
  flat in vec4 vExtra;

  /** The ivory of stripes and number discs, linear. */
  const vec3 IVORY = vec3(0.905, 0.855, 0.723);
  const vec3 INK = vec3(0.008);
  /** Sine of half the stripe's angular width, and of a dot's angular radius. */
  const float STRIPE = 0.6;
  const float DOT = 0.105;
  /** Radius of the number's disc, in ball radii, on large and on small balls. */
  const vec2 DISC = vec2(0.48, 0.56);
  /** Radii in pixels between which the disc grows, and below which it gives way to larger digits. */
  const vec2 GROWS = vec2(26.0, 12.0);
  const vec2 BARE = vec2(11.0, 13.0);
  /** Half the side of a label, in radii of its disc, and in ball radii without a disc. */
  const float LABEL = 0.78;
  const float BARE_LABEL = 0.64;

  /** Turns v by the conjugate of the quaternion q. */
  vec3 unturned(vec4 q, vec3 v) {
    return v + 2.0 * cross(cross(v, q.xyz) + q.w * v, q.xyz);
  }

  /** Colour of the skin in the direction n of the ball's axes, for a ball of size pixels in radius. */
  vec3 skin(vec3 n, float size, float blur) {
    vec3 color = vBody.rgb;
    if (vExtra.w == 1.0) {
      color = mix(color, IVORY, smoothstep(STRIPE - blur, STRIPE + blur, abs(n.y)));
    } else if (vExtra.w == 2.0) {
      vec3 a = abs(n);
      float sine = sqrt(1.0 - min(1.0, pow(max(a.x, max(a.y, a.z)), 2.0)));
      color = mix(vExtra.rgb, color, smoothstep(DOT - blur, DOT + blur, sine));
    }
    if (vBody.w < 0.0) return color;
    float disc = mix(DISC.y, DISC.x, smoothstep(GROWS.y, GROWS.x, size));
    float shown = smoothstep(BARE.x, BARE.y, size);
    vec2 place = vec2(n.z < 0.0 ? -n.x : n.x, n.y);
    color = mix(color, IVORY, shown * (1.0 - smoothstep(disc - blur, disc + blur, length(place))));
    place /= mix(BARE_LABEL, LABEL * disc, shown);
    vec2 cell = vec2(mod(vBody.w, cells), floor(vBody.w / cells));
    float inside = step(max(abs(place.x), abs(place.y)), 1.0);
    float ink = inside * texture(labels, (cell + 0.5 + 0.5 * place) / cells, -0.7).r;
    float light = dot(vBody.rgb, vec3(0.2126, 0.7152, 0.0722));
    vec3 pen = mix(light > 0.22 ? INK : vec3(1.0), INK, shown);
    return mix(color, pen, ink);
  }

  void main() {
    vec3 ray = normalize(vBall.xyz + vOffset);
    // Nearest point of the ray to the centre, relative to the centre; exact for distant cameras.
    vec3 nearest = vOffset - ray * dot(vOffset, ray);
    float radius = vBall.w;
    float miss = length(nearest);
    float pixel = length(vBall.xyz) / pixels;
    float coverage = clamp((radius - miss) / pixel + 0.5, 0.0, 1.0);
    if (coverage == 0.0) discard;
    float depth = sqrt(max(0.0, radius * radius - miss * miss));
    vec3 normal = normalize(nearest - ray * depth);
    vec3 place = vBall.xyz + radius * normal;
    float clip = projectionMatrix[2][2] * place.z + projectionMatrix[3][2];
    gl_FragDepth = clamp(0.5 - 0.5 * clip / place.z, 0.0, 1.0);

    vec3 n = normal * mat3(viewMatrix);
    vec3 back = -ray * mat3(viewMatrix);
    float facing = max(dot(n, back), 0.0);
    float size = radius / pixel;
    float blur = 0.6 / size / max(facing, 0.3);
    vec3 albedo = skin(unturned(vTurn, n), size, blur);

    float lit = max(dot(n, toLamp), 0.0);
    vec3 light = mix(ground, sky, 0.5 + 0.5 * n.z) + lamp * lit;
    // The cloth below takes light away.
    light *= mix(0.45, 1.0, smoothstep(-0.9, 0.15, n.z));
    // Blinn (1977), with Schlick's Fresnel term (1994) for the polish.
    float shine = pow(max(dot(n, normalize(toLamp + back)), 0.0), 180.0);
    float fresnel = 0.04 + 0.5 * pow(1.0 - facing, 5.0);
    vec3 color = albedo * light * RECIPROCAL_PI + lamp * (0.32 * shine * lit) + sky * (0.16 * fresnel);
    gl_FragColor = vec4(color, coverage);
    #include <colorspace_fragment>
  }
`;

/** For the shadow map: discs that face the lamp. */
export const SHADOW_VERTEX = `
  ${INSTANCE}
  out vec2 vPlace;
  void main() {
    vPlace = position.xy;
    vec4 center = viewMatrix * vec4(ball.xyz, 1.0);
    gl_Position = projectionMatrix * (center + vec4(ball.w * position.xy, 0.0, 0.0));
  }
`;

export const SHADOW_FRAGMENT = `
  in vec2 vPlace;
  void main() {
    if (dot(vPlace, vPlace) > 1.0) discard;
    gl_FragColor = vec4(1.0);
  }
`;
