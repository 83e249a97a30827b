// The shaders. Positions are relative to the eye, so that floats keep their digits far from the origin.
#pragma once

namespace physim::client {

inline constexpr const char* kGroundVertex = R"(#version 330 core
layout(location = 0) in vec2 corner;
uniform mat4 matrix;
uniform float height;  // of the ground above the eye
uniform float reach;
out vec3 place;
void main() {
  place = vec3(corner.x * reach, height, corner.y * reach);
  gl_Position = matrix * vec4(place, 1.0);
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

inline constexpr const char* kGroundFragment = "#version 330 core\n" PHYSIM_SHADOW_LOOKUP R"(
in vec3 place;
uniform vec3 near_colour, far_colour;
uniform float reach;
out vec4 colour;
void main() {
  float away = clamp(length(place.xz) / reach * 4.0, 0.0, 1.0);
  colour = vec4(mix(near_colour, far_colour, sqrt(away)), 1.0);
  if (has_shadows != 0) colour.rgb *= 0.55 + 0.45 * sunlight(place);
}
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
uniform vec3 to_sun;
uniform float map_pixel;  // of the shadow map [m]
uniform float haze;       // what is that far away is as the sky
out vec4 colour;
void main() {
  vec3 n = normalize(facing);
  if (dot(n, place) > 0.0) n = -n;  // sheets are seen from both sides
  float sun_on_it = max(dot(n, to_sun), 0.0);
  if (sun_on_it > 0.0) sun_on_it *= sunlight(place + n * (map_pixel * 1.5));
  float sky = 0.5 + 0.5 * n.y;
  vec3 light = mix(vec3(0.20, 0.19, 0.18), vec3(0.36, 0.40, 0.46), sky) + vec3(0.80, 0.76, 0.68) * sun_on_it;
  vec3 seen = shade.rgb * light;
  float away = clamp(length(place) / haze, 0.0, 1.0);
  colour = vec4(mix(seen, vec3(0.075, 0.086, 0.105), away * away), shade.a);
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
out vec4 shade;
out vec3 place;
noperspective out float across;  // on the screen, where the quad has the same width everywhere
flat out float half_width;
flat out float fog;
void main() {
  vec4 from = matrix * vec4(a, 1.0), to = matrix * vec4(b, 1.0);
  float s = 0.0, e = 1.0;
  if (from.w < near && to.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (from.w < near) s = (near - from.w) / (to.w - from.w);
  if (to.w < near) e = (near - from.w) / (to.w - from.w);
  vec4 start = mix(from, to, s), end = mix(from, to, e);
  vec2 p = start.xy / start.w * size, q = end.xy / end.w * size;
  vec2 along = q - p;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  half_width = width_fog.x * 0.5;
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
out vec4 colour;
void main() {
  if (fog > 0.0 && part < 1.0) discard;  // the grid does not
  float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0) * part;
  if (fog > 0.0) cover *= clamp(1.0 - length(place) / fog, 0.0, 1.0);
  if (cover <= 0.003) discard;
  colour = vec4(shade.rgb, shade.a * cover);
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
  colour = vec4(shade.rgb * light, shade.a * cover);
}
)";

inline constexpr const char* kCrowdVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 dot_colour;
uniform mat4 matrix;
uniform float pixels;
out vec4 shade;
void main() {
  gl_Position = matrix * vec4(at, 1.0);
  gl_PointSize = pixels;
  shade = dot_colour;
}
)";

inline constexpr const char* kCrowdFragment = R"(#version 330 core
in vec4 shade;
out vec4 colour;
void main() { colour = shade; }
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
void main() {
  vec4 centre = matrix * vec4(at, 1.0);
  float per_metre = focal / max(centre.w, 1e-4);
  vec2 wanted = half_size * per_metre;
  vec2 shown = max(wanted, vec2(turn_pixels.y));
  shade = sprite_colour;
  shade.a *= clamp(wanted.x * wanted.y / (shown.x * shown.y), 0.6, 1.0);
  float c = cos(turn_pixels.x), s = sin(turn_pixels.x);
  vec2 offset = mat2(c, s, -s, c) * (corner * shown);
  spot = corner;
  gl_Position = centre.w < 1e-4 ? vec4(2.0, 2.0, 2.0, 1.0) : centre + vec4(offset * 2.0 / size * centre.w, 0.0, 0.0);
}
)";

inline constexpr const char* kSpriteFragment = R"(#version 330 core
in vec4 shade;
in vec2 spot;
out vec4 colour;
void main() {
  float away = dot(spot, spot);
  if (away >= 1.0) discard;
  float soft = 1.0 - away;
  colour = vec4(shade.rgb * (0.85 + 0.3 * soft * soft), shade.a * soft);
}
)";

}  // namespace physim::client
