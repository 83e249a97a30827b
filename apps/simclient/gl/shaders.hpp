// The shaders. Positions are relative to the eye, so that floats keep their digits far from the origin.
#pragma once

namespace physim::client {

inline constexpr const char* kWorldVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
uniform vec3 forward, right, up;  // of the eye; right and up reach to the rims of the view
uniform vec2 part;                // of the view from below: where it begins, and how much of it
out vec3 way;
void main() {
  vec2 at = vec2(corner.x, mix(-1.0, 1.0, part.x + part.y * (corner.y * 0.5 + 0.5)));
  way = forward + right * at.x + up * at.y;
  gl_Position = vec4(at, 0.0, 1.0);
}
)";

// How much of the sun reaches a place: 1, or less in shadow. Edges are as soft as a few pixels of the map.
#define PHYSIM_SHADOW_LOOKUP                                                         \
  "uniform int has_shadows;\n"                                                       \
  "uniform sampler2DShadow shadow_map;\n"                                            \
  "uniform mat4 sun;\n"                                                              \
  "float sunlight(vec3 at) {\n"                                                      \
  "  if (has_shadows == 0) return 1.0;\n"                                            \
  "  vec3 on_map = (sun * vec4(at, 1.0)).xyz * 0.5 + 0.5;\n"                         \
  "  if (any(greaterThan(abs(on_map - 0.5), vec3(0.495)))) return 1.0;\n"            \
  "  float light = 0.0;\n"                                                           \
  "  for (int i = 0; i < 4; ++i) {\n"                                                \
  "    vec2 aside = vec2(float(i & 1) - 0.5, float(i >> 1) - 0.5) * 1.6 / 1024.0;\n" \
  "    light += texture(shadow_map, on_map + vec3(aside, 0.0));\n"                   \
  "  }\n"                                                                            \
  "  vec2 rim = smoothstep(0.42, 0.495, abs(on_map.xy - 0.5));\n"                    \
  "  return mix(light * 0.25, 1.0, max(rim.x, rim.y));\n"                            \
  "}\n"

// Sky, ground or globe: what each pixel's line of sight meets. Software rendering computes both sides of an `if`, so
// each is a program of its own, by the names that its head defines.
inline constexpr const char* kSkyHead = "#version 330 core\n";
inline constexpr const char* kGroundHead = "#version 330 core\n#define GROUND\n";
inline constexpr const char* kDeepGroundHead = "#version 330 core\n#define GROUND\n#define DEPTH\n";
inline constexpr const char* kShadowedGroundHead =
    "#version 330 core\n#define GROUND\n#define DEPTH\n#define SHADOWS\n";
inline constexpr const char* kGlobeHead = "#version 330 core\n#define GLOBE\n#define DEPTH\n";
inline constexpr const char* kWorldFragment = PHYSIM_SHADOW_LOOKUP R"(
in vec3 way;
uniform vec3 zenith, horizon, below, glow, to_sun;
uniform float air;          // what is left of it about the eye
uniform float height;       // of the ground above the eye
uniform vec3 ground, sea;
uniform vec4 grid, cloud;
uniform vec2 grid_at;       // of the eye, in steps of the grid
uniform float grid_step;
uniform float haze;         // where half of the ground's colour is left
uniform float grain, shadow_left;
uniform sampler2D unevenness;
uniform float globe;        // its radius
uniform vec3 centre;        // of the globe
uniform float beyond;       // square of the centre's distance, less that of the radius
uniform mat3 to_geographic;
uniform mat4 matrix;
out vec4 colour;

vec3 with_glow(vec3 c, vec3 d) {
  float s = max(dot(d, to_sun), 0.0);
  float near = s * s;
  near *= near, near *= near;
  float nearer = near * near;
  nearer *= nearer, nearer *= nearer;
  return mix(c, glow, 0.22 * near + 0.30 * nearer);
}

// Clouds of a layer above the eye, and mist below the eye where there is no ground.
float clouds(vec3 d) {
  vec2 p = d.xz / (abs(d.y) + 0.14);
  float n = 0.62 * texture(unevenness, p * 0.07).r + 0.38 * texture(unevenness, p.yx * 0.19 + 0.37).r;
  return smoothstep(0.46, 0.72, n) * smoothstep(0.0, 0.10, abs(d.y));
}

vec3 sky(vec3 d) {
  vec3 c = mix(horizon, zenith, 1.0 - exp2(-max(d.y, 0.0) * 4.5));
  c = mix(c, below, 1.0 - exp2(-max(-d.y, 0.0) * 8.0));
#if !defined(GLOBE) && !defined(GROUND)
  c = mix(c, cloud.rgb, cloud.a * air * clouds(d));
#endif
  float disc = smoothstep(0.99980, 0.99992, dot(d, to_sun)) * step(0.2, glow.r + glow.g);
  return mix(with_glow(c, d), vec3(1.0, 0.98, 0.94), disc);
}

float lines(vec2 p, vec2 pixel, float wide) {
  vec2 on = clamp(wide * 0.5 + 0.5 - abs(fract(p - 0.5) - 0.5) / pixel, 0.0, 1.0);
  on *= clamp(1.4 - 3.1 * pixel, 0.0, 1.0);  // so dense that they are one grey
  return max(on.x, on.y);
}

void main() {
  vec3 d = normalize(way);
#if defined(GROUND)
  float far = height / min(d.y, -1e-6);
  vec3 place = d * far;
  vec2 p = grid_at + place.xz / grid_step, pixel = max(fwidth(p), vec2(1e-9));
  vec3 c = ground * (1.0 + grain * (texture(unevenness, p / 20.0).r - 0.5));
  #if defined(SHADOWS)
  c *= shadow_left + (1.0 - shadow_left) * sunlight(place);
  #endif
  c = mix(c, grid.rgb, grid.a * max(lines(p, pixel, 1.3), 0.35 * lines(p * 5.0, pixel * 5.0, 1.0)));
  vec3 seen = mix(with_glow(horizon, vec3(d.x, 0.0, d.z)), c, exp2(-length(place.xz) / haze));
#elif defined(GLOBE)
  // Beside the globe all is computed at its rim, so that differences between pixels are small there.
  float b = dot(d, centre), q = b * b - beyond, far = beyond / (max(b, 0.0) + sqrt(max(q, 0.0)) + 1e-6);
  vec3 n = normalize(d * far - centre), g = to_geographic * n;
  vec2 at = vec2(atan(g.y, g.x), asin(clamp(g.z, -1.0, 1.0))) * 57.29578;
  vec2 pixel = max(vec2(min(fwidth(at.x), fwidth(mod(at.x + 360.0, 360.0))), fwidth(at.y)), vec2(1e-9));
  vec2 thin = clamp(1.0 - abs(fract(at / 10.0 - 0.5) - 0.5) * 10.0 / pixel, 0.0, 1.0);
  vec2 thick = clamp(1.5 - abs(at) / pixel, 0.0, 1.0);
  vec2 dense = 1.0 - smoothstep(vec2(0.8), vec2(3.0), pixel);
  thin *= dense, thick *= dense;
  float day = 0.42 + 0.58 * smoothstep(-0.15, 0.5, dot(n, to_sun));
  vec3 sphere = mix(sea * day, grid.rgb * day, max(max(thin.x, thin.y) * grid.a, max(thick.x, thick.y) * 0.8));
  float rim = 1.0 - clamp(dot(n, -d), 0.0, 1.0);
  sphere = mix(sphere, horizon, 0.55 * rim * rim * rim);
  float above = sqrt(max(dot(centre, centre) - b * b, 0.0)) - globe;
  float halo = b > 0.0 ? exp2(-max(above, 0.0) / 25000.0) : 0.0;
  vec3 space = mix(mix(below * 0.06, sky(d), air), horizon, 0.75 * halo);
  bool hits = b > 0.0 && q > 0.0;
  vec3 seen = hits ? sphere : space;
  if (!hits) far = 0.0;
#else
  vec3 seen = sky(d);
#endif
  colour = vec4(seen, 1.0);
#if defined(DEPTH)
  gl_FragDepth = 1.0;
  if (far > 0.0) {  // a little farther: what lies on it is seen
    vec4 at = matrix * vec4(d * (far * 1.001), 1.0);
    gl_FragDepth = clamp(at.z / at.w * 0.5 + 0.5, 0.0, 1.0);
  }
#endif
}
)";

// The kept picture of sky and ground.
inline constexpr const char* kBackdropVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
)";

inline constexpr const char* kBackdropFragment = R"(#version 330 core
uniform sampler2D kept;
uniform vec2 corner_at, size;  // of the viewport in pixels
out vec4 colour;
void main() { colour = texture(kept, (gl_FragCoord.xy - corner_at) / size); }
)";

inline constexpr const char* kThingVertex = R"(#version 330 core
layout(location = 0) in vec3 at;  // from the scenery's origin
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 thing_colour;
uniform mat4 matrix;
uniform vec3 origin;    // of the scenery, relative to the eye
uniform float stretch;  // of heights
out vec3 place;
out vec3 facing;
out vec4 shade;
void main() {
  place = origin + at * vec3(1.0, stretch, 1.0);
  facing = normal * vec3(1.0, 1.0 / stretch, 1.0);
  shade = thing_colour;
  gl_Position = matrix * vec4(place, 1.0);
}
)";

inline constexpr const char* kThingFragment = "#version 330 core\n" PHYSIM_SHADOW_LOOKUP R"(
in vec3 place;
in vec3 facing;
in vec4 shade;
uniform vec3 to_sun, sunlight_colour, skylight, earthlight, horizon;
uniform float map_pixel;  // of the shadow map [m]
uniform float haze;       // where half of the colour is left
uniform float contour_step, contour_at;  // between lines of equal height on terrain; height of the eye in them
out vec4 colour;
void main() {
  vec3 n = normalize(facing);
  if (dot(n, place) > 0.0) n = -n;  // sheets are seen from both sides
  float sun_on_it = max(dot(n, to_sun), 0.0);
  if (sun_on_it > 0.0) sun_on_it *= sunlight(place + n * (map_pixel * 1.5));
  vec3 light = mix(earthlight, skylight, 0.5 + 0.5 * n.y) + sunlight_colour * sun_on_it;
  vec3 seen = shade.rgb * light;
  float alpha = shade.a;
  if (abs(shade.a * 255.0 - 254.0) < 0.5) {  // terrain
    alpha = 1.0;
    float p = place.y / contour_step + contour_at, pixel = max(fwidth(p), 1e-9);
    float on = clamp(1.1 - abs(fract(p - 0.5) - 0.5) / pixel, 0.0, 1.0) * (1.0 - smoothstep(0.15, 0.5, pixel));
    seen *= 1.0 - 0.32 * on;
  }
  colour = vec4(mix(horizon, seen, exp2(-length(place) / haze)), alpha);
}
)";

// A body at its attitude. It is as near as its front: what it lies on, or hits, does not cut it.
inline constexpr const char* kBodyVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 body_colour;
uniform mat4 matrix;
uniform vec3 centre;     // relative to the eye
uniform mat3 turn;       // from body axes
uniform vec3 extent;
uniform float reach;     // half of its diagonal
uniform vec3 track_colour;
out vec3 place;
out vec3 facing;
out vec3 shade;
void main() {
  vec3 out_there = turn * (at * extent);
  place = centre + out_there;
  facing = turn * (normal / extent);
  shade = abs(body_colour.a * 255.0 - 254.0) < 0.5 ? track_colour : body_colour.rgb;
  gl_Position = matrix * vec4(place, 1.0);
  float away = max(length(centre), 1e-6);
  vec4 nearest = matrix * vec4(centre * max(1.0 - 1.5 * reach / away, 0.0), 1.0);
  float behind = dot(out_there, centre / away) / reach;  // -1 to 1: parts of it hide others
  if (nearest.w > 1e-4) gl_Position.z = (nearest.z / nearest.w + 4e-5 * (1.0 + behind)) * gl_Position.w;
}
)";

inline constexpr const char* kBodyFragment = R"(#version 330 core
in vec3 place;
in vec3 facing;
in vec3 shade;
uniform vec3 to_sun, sunlight_colour, skylight, earthlight;
out vec4 colour;
void main() {
  vec3 n = normalize(facing), to_eye = -normalize(place);
  if (dot(n, to_eye) < 0.0) n = -n;
  vec3 light = mix(earthlight, skylight, 0.5 + 0.5 * n.y) + sunlight_colour * max(dot(n, to_sun), 0.0);
  float glint = pow(max(dot(n, normalize(to_sun + to_eye)), 0.0), 24.0);
  float rim = 1.0 - 0.35 * smoothstep(0.5, 0.95, 1.0 - dot(n, to_eye));  // it stands out from any ground
  colour = vec4(shade * light * 1.1 * rim + sunlight_colour * 0.3 * glint, 1.0);
}
)";

inline constexpr const char* kShadowFragment = R"(#version 330 core
void main() {}
)";

// The shadow of a ball: a disc that faces the sun.
inline constexpr const char* kBallShadowVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
layout(location = 1) in vec3 at;
layout(location = 3) in vec2 radius_pixels;
uniform mat4 matrix;   // of the eye
uniform mat4 sun;
uniform vec2 size;
uniform float focal;
uniform float metres;  // that the map is wide
out vec2 spot;
void main() {
  vec4 centre = matrix * vec4(at, 1.0);
  float radius = max(radius_pixels.x, radius_pixels.y * max(centre.w, 1e-4) / focal);
  spot = corner;
  gl_Position = sun * vec4(at, 1.0) + vec4(corner * radius * 2.0 / metres, 0.0, 0.0);
}
)";

inline constexpr const char* kBallShadowFragment = R"(#version 330 core
in vec2 spot;
void main() { if (dot(spot, spot) > 1.0) discard; }
)";

// A line is a quad as wide as the line and one pixel more, which lets its edges fade out.
inline constexpr const char* kLineVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;  // x: 0 or 1, from a to b; y: -1 or 1, across
layout(location = 1) in vec3 a;
layout(location = 2) in vec3 b;
layout(location = 3) in vec4 line_colour;
layout(location = 4) in vec2 width_fog;
uniform mat4 matrix;
uniform vec2 size;   // of the viewport in pixels
uniform float near;  // what is nearer is cut off
uniform float casing_width;  // > 0: the casings of those that have one are drawn
out vec4 shade;
out vec3 place;
noperspective out float across;  // on the screen, where the quad has the same width everywhere
flat out float half_width;
flat out float fog;
void main() {
  vec4 from = matrix * vec4(a, 1.0), to = matrix * vec4(b, 1.0);
  if (casing_width > 0.0 && width_fog.y >= 0.0) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  float s = 0.0, e = 1.0;
  if (from.w < near && to.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (from.w < near) s = (near - from.w) / (to.w - from.w);
  if (to.w < near) e = (near - from.w) / (to.w - from.w);
  vec4 start = mix(from, to, s), end = mix(from, to, e);
  vec2 p = start.xy / start.w * size, q = end.xy / end.w * size;
  vec2 along = q - p;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  half_width = width_fog.x * 0.5 + casing_width;
  across = corner.y * (half_width + 1.0);
  vec4 at = corner.x < 0.5 ? start : end;
  vec2 offset = vec2(-along.y, along.x) * across + along * (corner.x < 0.5 ? -0.5 : 0.5);
  gl_Position = at + vec4(offset * 2.0 / size * at.w, 0.0, 0.0);
  place = mix(a, b, corner.x < 0.5 ? s : e);
  shade = line_colour;
  fog = width_fog.y;
}
)";

inline constexpr const char* kLineFragment = R"(#version 330 core
in vec4 shade;
in vec3 place;
noperspective in float across;
flat in float half_width;
flat in float fog;
uniform float part;  // of its opacity: what is hidden by things shows through
uniform float casing_width;
uniform vec4 casing;
out vec4 colour;
void main() {
  if (fog > 0.0 && part < 1.0) discard;  // the grid does not
  float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0) * part;
  if (fog > 0.0) cover *= clamp(1.0 - length(place) / fog, 0.0, 1.0);
  if (cover <= 0.003) discard;
  colour = casing_width > 0.0 ? vec4(casing.rgb, casing.a * shade.a * cover) : vec4(shade.rgb, shade.a * cover);
}
)";

inline constexpr const char* kBallVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;  // -1..1
layout(location = 1) in vec3 at;
layout(location = 2) in vec4 ball_colour;
layout(location = 3) in vec2 radius_pixels;
uniform mat4 matrix;
uniform vec2 size;
uniform float focal;  // pixels of a metre at a metre
out vec4 shade;
out vec2 spot;
flat out float pixels;
void main() {
  vec4 centre = matrix * vec4(at, 1.0);
  pixels = max(radius_pixels.y, radius_pixels.x * focal / max(centre.w, 1e-4));
  spot = corner * (1.0 + 1.0 / pixels);
  shade = ball_colour;
  gl_Position = centre.w < 1e-4 ? vec4(2.0, 2.0, 2.0, 1.0)
                                : centre + vec4(spot * pixels * 2.0 / size * centre.w, 0.0, 0.0);
  // As near as the ball's front: what it lies on does not cut it.
  vec3 front = at * max(1.0 - pixels / focal * centre.w / max(length(at), 1e-6), 0.0);
  vec4 nearest = matrix * vec4(front, 1.0);
  if (nearest.w > 1e-4) gl_Position.z = nearest.z / nearest.w * gl_Position.w;
}
)";

inline constexpr const char* kBallFragment = R"(#version 330 core
in vec4 shade;
in vec2 spot;
flat in float pixels;
uniform float part;
out vec4 colour;
void main() {
  float away = length(spot);
  float cover = clamp((1.0 - away) * pixels + 0.5, 0.0, 1.0) * part;
  if (cover <= 0.0) discard;
  float up = sqrt(max(0.0, 1.0 - away * away));
  float light = pixels < 3.0 ? 1.0 : 0.62 + 0.38 * clamp(dot(vec3(spot, up), vec3(-0.35, 0.6, 0.72)), 0.0, 1.0);
  if (pixels >= 3.0) light *= 1.0 - 0.5 * smoothstep(0.72, 1.0, away);  // its rim stands out from any ground
  colour = vec4(shade.rgb * light, shade.a * cover);
}
)";

// A shadow on the ground, straight below: a soft disc that lies there.
inline constexpr const char* kDiscVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
layout(location = 1) in vec3 at;
layout(location = 2) in vec4 disc_colour;
layout(location = 3) in vec2 radius_pixels;
uniform mat4 matrix;
uniform float focal;
out vec4 shade;
out vec2 spot;
void main() {
  vec4 centre = matrix * vec4(at, 1.0);
  float radius = max(radius_pixels.x, radius_pixels.y * max(centre.w, 1e-4) / focal);
  spot = corner;
  shade = disc_colour;
  gl_Position = matrix * vec4(at + vec3(corner.x * radius, 0.0, corner.y * radius), 1.0);
}
)";

inline constexpr const char* kDiscFragment = R"(#version 330 core
in vec4 shade;
in vec2 spot;
out vec4 colour;
void main() {
  float soft = 1.0 - dot(spot, spot);
  if (soft <= 0.0) discard;
  colour = vec4(shade.rgb, shade.a * smoothstep(0.0, 0.6, soft));
}
)";

inline constexpr const char* kCrowdVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 dot_colour;
uniform mat4 matrix;
uniform float pixels;   // at the distance of what is looked at
uniform float middle;   // that distance
uniform float haze;     // where half of the colour is left
uniform vec3 horizon;
out vec4 shade;
flat out float dot_pixels;
void main() {
  gl_Position = matrix * vec4(at, 1.0);
  float away = max(gl_Position.w, 1e-4);
  gl_PointSize = clamp(pixels * middle / away, 1.0, 2.0 * pixels);
  dot_pixels = gl_PointSize;
  shade = vec4(mix(horizon, dot_colour.rgb, exp2(-away / haze)), dot_colour.a);
}
)";

inline constexpr const char* kCrowdFragment = R"(#version 330 core
in vec4 shade;
out vec4 colour;
void main() { colour = shade; }
)";

inline constexpr const char* kRoundCrowdFragment = R"(#version 330 core
in vec4 shade;
flat in float dot_pixels;
out vec4 colour;
void main() {
  float cover = clamp((0.5 - length(gl_PointCoord - 0.5)) * dot_pixels + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;
  colour = vec4(shade.rgb, shade.a * cover);
}
)";

// A soft disc that faces the eye, turned about the way to it. One that would be smaller than a pixel or two is fainter
// instead, so that what is far does not flicker.
inline constexpr const char* kSpriteVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
layout(location = 1) in vec3 at;
layout(location = 2) in vec4 sprite_colour;
layout(location = 3) in vec2 half_size;    // [m]
layout(location = 4) in vec2 turn_pixels;  // [rad], least half size
uniform mat4 matrix;
uniform vec2 size;
uniform float focal;
out vec4 shade;
out vec2 spot;
flat out float crisp;  // small ones have little room for a soft rim
void main() {
  vec4 centre = matrix * vec4(at, 1.0);
  float per_metre = focal / max(centre.w, 1e-4);
  vec2 wanted = half_size * per_metre;
  vec2 shown = max(wanted, vec2(turn_pixels.y));
  shade = sprite_colour;
  shade.a *= clamp(wanted.x * wanted.y / (shown.x * shown.y), 0.6, 1.0);
  crisp = clamp(6.0 / shown.x, 1.0, 2.5);
  float c = cos(turn_pixels.x), s = sin(turn_pixels.x);
  vec2 offset = mat2(c, s, -s, c) * (corner * shown);
  spot = corner;
  gl_Position = centre.w < 1e-4 ? vec4(2.0, 2.0, 2.0, 1.0) : centre + vec4(offset * 2.0 / size * centre.w, 0.0, 0.0);
}
)";

inline constexpr const char* kSpriteFragment = R"(#version 330 core
in vec4 shade;
in vec2 spot;
flat in float crisp;
out vec4 colour;
void main() {
  float away = dot(spot, spot);
  if (away >= 1.0) discard;
  float soft = 1.0 - away;
  colour = vec4(shade.rgb * (0.85 + 0.3 * soft * soft), shade.a * min(1.0, soft * crisp));
}
)";

// The light about hot particles, which covers a part of what is behind it.
inline constexpr const char* kGlowVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;  // 0..1
uniform vec4 box;  // left, top, width and height, in parts of the view
out vec2 at;
void main() {
  at = corner;
  gl_Position = vec4(vec2(2.0, -2.0) * (box.xy + corner * box.zw) + vec2(-1.0, 1.0), 0.0, 1.0);
}
)";

inline constexpr const char* kGlowFragment = R"(#version 330 core
in vec2 at;
uniform sampler2D light;
uniform float cover;
out vec4 colour;
void main() {
  vec3 c = texture(light, at).rgb;
  colour = vec4(c, cover * max(c.r, max(c.g, c.b)));
}
)";

// Stars: points at directions.
inline constexpr const char* kStarVertex = R"(#version 330 core
layout(location = 0) in vec3 way;
layout(location = 1) in float brightness;
uniform mat4 matrix;
uniform float pixels;  // of the brightest
uniform float part;    // of their light that is left
uniform float lowest;  // height of those that are seen
out float light;
void main() {
  vec4 at = matrix * vec4(way, 1.0);
  gl_Position = vec4(at.xy, at.w * 0.999999, at.w);
  gl_PointSize = max(pixels * sqrt(brightness), 1.0);
  light = part * brightness * clamp((way.y - lowest) * 6.0, 0.0, 1.0);
}
)";

inline constexpr const char* kStarFragment = R"(#version 330 core
in float light;
out vec4 colour;
void main() { colour = vec4(0.93, 0.95, 1.0, light); }
)";

}  // namespace physim::client
