// Settings of scenes: [[material]], [[shape]], a table for each kind of which a shape has one, and [[thing]].
#include "scenario/published_materials.hpp"
#include "scenario/settings_parts.hpp"

namespace physim {

namespace {

// ------------------------------------------------------------------------------------------------- kinds by their name
/// A kind out of a variant, by the name that files call it.
template <class Variant>
struct NamedKind {
  std::string_view name;
  std::size_t index;  // in the variant
  void (*make)(Variant&);
};
template <class Kind, class Variant>
constexpr std::size_t kind_index() {
  return []<class... T>(const std::variant<T...>*) {
    std::size_t i = 0;
    static_cast<void>(((std::is_same_v<T, Kind> ? true : (++i, false)) || ...));
    return i;
  }(static_cast<const Variant*>(nullptr));
}
template <class Kind, class Variant>
constexpr NamedKind<Variant> named_kind(std::string_view name) {
  return {name, kind_index<Kind, Variant>(), [](Variant& v) { v.template emplace<Kind>(); }};
}

constexpr NamedKind<ShapeDef> kShapes[] = {
    named_kind<PlaneShape, ShapeDef>("plane"),       named_kind<SphereShape, ShapeDef>("sphere"),
    named_kind<BoxShape, ShapeDef>("box"),           named_kind<CapsuleShape, ShapeDef>("capsule"),
    named_kind<CylinderShape, ShapeDef>("cylinder"), named_kind<ConvexHullShape, ShapeDef>("hull"),
    named_kind<MeshShape, ShapeDef>("mesh"),         named_kind<HeightFieldShape, ShapeDef>("height_field"),
    named_kind<CompoundShape, ShapeDef>("compound"),
};
constexpr NamedKind<PenetrationDef> kPenetrations[] = {
    named_kind<ImpenetrableDef, PenetrationDef>("none"),
    named_kind<PonceletDef, PenetrationDef>("poncelet"),
    named_kind<YoungDef, PenetrationDef>("young"),
    named_kind<DeMarreDef, PenetrationDef>("de_marre"),
    named_kind<LambertDef, PenetrationDef>("lambert"),
    named_kind<BallisticLimitDef, PenetrationDef>("ballistic_limit"),
};

template <const auto& kKinds>
std::span<const std::string_view> kind_names() {
  static constexpr auto names = [] {
    std::array<std::string_view, std::size(kKinds)> list;
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = kKinds[i].name;
    return list;
  }();
  return names;
}

/// Which kind a variant holds; those without a name are nothing that a file can say.
template <const auto& kKinds, class Variant>
Choice kind_choice(Variant& variant) {
  return choice_where(
      kind_names<kKinds>(), [&variant](std::size_t i) { return kKinds[i].index == variant.index(); },
      [&variant](std::size_t i) {
        if (variant.index() != kKinds[i].index) kKinds[i].make(variant);
      });
}

/// The variant as this kind; what else it was is forgotten.
template <class Kind, class Variant>
Kind& as_kind(Variant& variant) {
  if (!std::holds_alternative<Kind>(variant)) variant.template emplace<Kind>();
  return std::get<Kind>(variant);
}

template <class Kind>
Kind& shape_as(const Scope& scope) {
  return as_kind<Kind>(scope.shape->shape);
}
template <class Kind>
Kind& penetration_as(const Scope& scope) {
  return as_kind<Kind>(scope.material->penetration);
}
template <class Kind>
bool is_shape(const Scope& scope) {
  return std::holds_alternative<Kind>(scope.shape->shape);
}
template <class Kind>
bool is_penetration(const Scope& scope) {
  return std::holds_alternative<Kind>(scope.material->penetration);
}
/// The triangles of a mesh out of a file are said by the file alone.
bool is_mesh_of_file(const Scope& scope) { return is_shape<MeshShape>(scope) && !scope.shape->file.empty(); }
bool is_mesh_of_terrain(const Scope& scope) { return is_shape<MeshShape>(scope) && !scope.shape->terrain.empty(); }
bool is_mesh_in_place(const Scope& scope) {
  return is_shape<MeshShape>(scope) && !is_mesh_of_file(scope) && !is_mesh_of_terrain(scope);
}
bool has_materials(const Scope& scope) { return is_shape<MeshShape>(scope) && !scope.shape->materials.empty(); }

bool is_field_of_file(const Scope& scope) { return is_shape<HeightFieldShape>(scope) && !scope.shape->file.empty(); }
bool is_field_in_place(const Scope& scope) { return is_shape<HeightFieldShape>(scope) && scope.shape->file.empty(); }

bool is_compound(const Scope& scope) { return scope.shape->is_compound(); }
ValueRef compound_slot(const Scope& scope) {
  static_cast<void>(shape_as<CompoundShape>(scope));
  return slot_of(scope, scope.shape->parts);
}

/// A compound without parts is of no kind yet.
ValueRef shape_kind_slot(const Scope& scope) {
  Choice slot = kind_choice<kShapes>(scope.shape->shape);
  slot.get = [of_variant = slot.get, &shape = *scope.shape] {
    const bool is_none = std::holds_alternative<CompoundShape>(shape.shape) && !shape.is_compound();
    return is_none ? std::nullopt : of_variant();
  };
  return slot;
}

/// Settings of shapes of a kind that a scenario has beside those of the library.
template <class Kind, auto kMember>
ValueRef of_shape_slot(const Scope& scope) {
  static_cast<void>(shape_as<Kind>(scope));
  return &(scope.shape->*kMember);
}
template <auto kMember>
ValueRef terrain_slot(const Scope& scope) {
  static_cast<void>(shape_as<MeshShape>(scope));
  return slot_of(scope, scope.shape->cut.*kMember);
}

// ------------------------------------------------------------------------------------------------ published materials
void take_preset(Material& material, Material preset) {
  preset.name = material.name;
  material = std::move(preset);
}

ValueRef material_preset_slot(const Scope& scope) {
  Material& material = *scope.material;
  return Choice{published_materials(), [] { return std::optional<std::size_t>(); },  // its numbers say all it says
                [&material](std::size_t i) { take_preset(material, *published_material(published_materials()[i])); }};
}

/// Another preset, which its numbers say, too.
ValueRef concrete_slot(const Scope& scope) {
  return said_elsewhere(
      [&material = *scope.material](double strength) { take_preset(material, materials::concrete(strength)); });
}

#define PHYSIM_MATERIAL(...) PHYSIM_ROW("material", material, __VA_ARGS__)
#define PHYSIM_PENETRATION(name, Kind, field, ...)                                                           \
  setting(                                                                                                   \
      "material." name "." #field, [](const Scope& s) { return slot_of(s, penetration_as<Kind>(s).field); }, \
      __VA_ARGS__, WhereTrue{is_penetration<Kind>})
#define PHYSIM_SHAPE_WHERE(is_there, name, Kind, field, ...)                                                     \
  setting(                                                                                                       \
      "shape." name "." #field, [](const Scope& s) { return slot_of(s, shape_as<Kind>(s).field); }, __VA_ARGS__, \
      WhereTrue{is_there})
#define PHYSIM_SHAPE(name, Kind, ...) PHYSIM_SHAPE_WHERE(is_shape<Kind>, name, Kind, __VA_ARGS__)
#define PHYSIM_FIELD_IN_PLACE(...) PHYSIM_SHAPE_WHERE(is_field_in_place, "height_field", HeightFieldShape, __VA_ARGS__)
#define PHYSIM_MESH_IN_PLACE(...) PHYSIM_SHAPE_WHERE(is_mesh_in_place, "mesh", MeshShape, __VA_ARGS__)
#define PHYSIM_PART(...) PHYSIM_ROW("shape.compound", part, __VA_ARGS__)
#define PHYSIM_THING(...) PHYSIM_ROW("thing", thing, __VA_ARGS__)

constexpr Range kPoints = {.low = 0, .high = 1e6};  // of lists

constexpr Entry kSceneSettings[] = {
    setting("material", PHYSIM_FIELD(scenario->materials), "what things are made of", at_most(1000)),
    PHYSIM_MATERIAL(name,
                    "for things, shape.compound.material and shape.mesh.materials, and in tables; default: material-1, "
                    "material-2, ..."),
    setting("material.preset", material_preset_slot,
            "a material whose numbers were published, to start from; the other keys change it", kPreset),
    setting("material.concrete", concrete_slot, "concrete of this compressive strength, instead of a preset",
            Quantity::pressure, Range{.low = 13e6, .high = 100e6}),
    PHYSIM_MATERIAL(restitution, "part of the speed along the normal that is left after a bounce", kFraction),
    PHYSIM_MATERIAL(friction, "Coulomb's, of what slides on it", at_least(0)),
    PHYSIM_MATERIAL(combine.restitution, "how it is combined with that of the projectile; of two rules the later one"),
    PHYSIM_MATERIAL(combine.friction, "how it is combined with that of the projectile; of two rules the later one"),
    PHYSIM_MATERIAL(grip_restitution, "part of the slip that comes back after a ball gripped", kFraction),
    PHYSIM_MATERIAL(density, "0: not known", Quantity::density, at_least(0)),
    PHYSIM_MATERIAL(ricochet.critical_angle, "from the surface; what comes in flatter is thrown off", Quantity::angle,
                    kBelowRightAngle),
    PHYSIM_MATERIAL(ricochet.restitution, "of what is thrown off: part of the speed along the normal that is left",
                    kFraction),
    PHYSIM_MATERIAL(ricochet.friction, "impulse along the surface over that along the normal", at_least(0)),
    PHYSIM_MATERIAL(ricochet.liquid, "angle and loss are those of spheres off a liquid of the density"),
    PHYSIM_PENETRATION("poncelet", PonceletDef, strength, "resistance to what moves slowly; 0: a liquid",
                       Quantity::pressure, at_least(0)),
    PHYSIM_PENETRATION("poncelet", PonceletDef, inertia, "resistance by the speed; solids 1, liquids 0.5", at_least(0)),
    PHYSIM_PENETRATION("poncelet", PonceletDef, crater,
                       "depth over which the resistance grows from 0, in diameters; concrete 2", at_least(0)),
    PHYSIM_PENETRATION("young", YoungDef, s_number, "penetrability: concrete about 1, soils more", at_least(0),
                       kShorthand),
    PHYSIM_PENETRATION("young", YoungDef, hard, "rock or concrete"),
    PHYSIM_PENETRATION("de_marre", DeMarreDef, quality, "limit speed over that of nickel steel", above(0), kShorthand),
    PHYSIM_PENETRATION("de_marre", DeMarreDef, plug, "part of a plug that the shot drives out", kFraction),
    PHYSIM_PENETRATION("lambert", LambertDef, coefficient,
                       "in m/s g^1/2 cm^-3/2: rolled homogeneous armour 4000, aluminium 1750", above(0), kShorthand),
    PHYSIM_PENETRATION("ballistic_limit", BallisticLimitDef, speed, "ballistic limit, straight on", Quantity::speed,
                       at_least(0), kShorthand),
    PHYSIM_PENETRATION("ballistic_limit", BallisticLimitDef, a, "part of the speed that is left at high speed",
                       kFraction),
    PHYSIM_PENETRATION("ballistic_limit", BallisticLimitDef, p, "exponent; 2: a constant energy is lost",
                       between(1, 100)),
    setting(
        "material.penetration",
        [](const Scope& s) -> ValueRef { return kind_choice<kPenetrations>(s.material->penetration); },
        "how deep a projectile goes, where no table says so"),
    PHYSIM_MATERIAL(spread.deflection, "standard deviation of the direction of what comes out", Quantity::angle,
                    kBelowRightAngle),
    PHYSIM_MATERIAL(spread.yaw, "standard deviation of the angle between its axis and its direction", Quantity::angle,
                    kBelowRightAngle),

    setting("shape", PHYSIM_FIELD(scenario->shapes), "shapes of things; each is of one kind", at_most(10000)),
    PHYSIM_ROW("shape", shape, name, "for thing.shape and shape.compound.shape; default: shape-1, shape-2, ..."),
    PHYSIM_SHAPE("sphere", SphereShape, radius, "about the origin", Quantity::length, above(0), kShorthand),
    PHYSIM_SHAPE("box", BoxShape, half, "half of its edges, about the origin", Quantity::length, kShorthand),
    PHYSIM_SHAPE("capsule", CapsuleShape, radius, "along the y axis, round at both ends", Quantity::length, above(0)),
    PHYSIM_SHAPE("capsule", CapsuleShape, half_height, "of the cylinder between the ends", Quantity::length,
                 at_least(0)),
    PHYSIM_SHAPE("cylinder", CylinderShape, radius, "along the y axis", Quantity::length, above(0)),
    PHYSIM_SHAPE("cylinder", CylinderShape, half_height, "along the y axis", Quantity::length, above(0)),
    PHYSIM_SHAPE("hull", ConvexHullShape, points, "the smallest convex body that holds them", Quantity::length, kPoints,
                 kShorthand),
    setting("shape.mesh.file", of_shape_slot<MeshShape, &ScenarioShape::file>,
            "OBJ, STL, glTF or others, found from the scenario's folder", kShorthand, WhereTrue{is_mesh_of_file}),
    setting("shape.mesh.terrain", of_shape_slot<MeshShape, &ScenarioShape::terrain>,
            "instead of it: heights of the Earth, GeoTIFF, SRTM's .hgt or others, found from the scenario's folder",
            WhereTrue{is_mesh_of_terrain}),
    setting("shape.mesh.reach", terrain_slot<&TerrainCut::reach>,
            "so far north, south, east and west of environment.earth.latitude and longitude", Quantity::length,
            or_infinite(above(0)), WhereTrue{is_mesh_of_terrain}),
    setting("shape.mesh.every", terrain_slot<&TerrainCut::every>, "of its points, 1: all of them", between(1, 65536),
            WhereTrue{is_mesh_of_terrain}),
    setting("shape.mesh.geoid", terrain_slot<&TerrainCut::geoid>,
            "of sea level above the ellipsoid, added to all heights; 0 where altitude is that above sea level",
            Quantity::length, between(-200, 200), WhereTrue{is_mesh_of_terrain}),
    setting("shape.mesh.missing", terrain_slot<&TerrainCut::missing>,
            "height above sea level of points that have none; default: they are an error", Quantity::length,
            between(-1e5, 1e5), WhereTrue{is_mesh_of_terrain}),
    PHYSIM_MESH_IN_PLACE(vertices, "instead of a file", Quantity::length, kPoints),
    PHYSIM_MESH_IN_PLACE(triangles, "numbers of vertices, from 0, counterclockwise as seen from outside", kPoints),
    setting("shape.mesh.materials", of_shape_slot<MeshShape, &ScenarioShape::materials>,
            "names of materials or presets, one for each triangle or one for all; none: that of the thing",
            WhereTrue{has_materials}),
    setting("shape.height_field.file", of_shape_slot<HeightFieldShape, &ScenarioShape::file>,
            "a picture in grey, PNG of 8 or 16 bits best, found from the scenario's folder",
            WhereTrue{is_field_of_file}),
    setting("shape.height_field.low", of_shape_slot<HeightFieldShape, &ScenarioShape::low>,
            "height of black in the file", Quantity::length, WhereTrue{is_field_of_file}),
    setting("shape.height_field.high", of_shape_slot<HeightFieldShape, &ScenarioShape::high>,
            "height of white in the file", Quantity::length, WhereTrue{is_field_of_file}),
    PHYSIM_FIELD_IN_PLACE(columns, "instead of a file: points along x", between(0, 65536)),
    PHYSIM_FIELD_IN_PLACE(rows, "instead of a file: points along z", between(0, 65536)),
    PHYSIM_SHAPE("height_field", HeightFieldShape, spacing_x, "between columns", Quantity::length, above(0)),
    PHYSIM_SHAPE("height_field", HeightFieldShape, spacing_z, "between rows", Quantity::length, above(0)),
    PHYSIM_FIELD_IN_PLACE(heights, "instead of a file: y of each point, row by row", Quantity::length),
    setting("shape.compound", compound_slot, "other shapes that move as one, each at its place",
            Range{.low = 1, .high = 10000}, WhereTrue{is_compound}),
    PHYSIM_PART(shape, "name of another shape, no plane and no compound", kRequired),
    PHYSIM_PART(material, "name of its material, or of a preset; empty: that of the thing"),
    PHYSIM_PART(position, "of its origin in the compound's frame", Quantity::length),
    PHYSIM_ROTATION("shape.compound", part),
    PHYSIM_PART(scale, "along all axes", between(1e-9, 1e9)),
    setting("shape.kind", shape_kind_slot, "where no table says so; plane: everything below y = 0"),

    setting("thing", PHYSIM_FIELD(scenario->things), "what stands there, for projectiles to hit", at_most(100000)),
    PHYSIM_THING(name, "in tables; default: thing-1, thing-2, ..."),
    PHYSIM_THING(shape, "name of its shape", kRequired),
    PHYSIM_THING(material, "name of its material, or of a preset; empty: that of every scene"),
    PHYSIM_THING(position, "of its origin", Quantity::length),
    PHYSIM_ROTATION("thing", thing),
    PHYSIM_THING(scale, "along all axes", above(0)),
    PHYSIM_THING(layers, "bits, for shot.body.collision.layers", kBits),
    PHYSIM_THING(sensor, "told of, and passed"),
    PHYSIM_THING(start, "time at which a steady motion has it at its position", Quantity::time),
    PHYSIM_THING(velocity, "steady", Quantity::speed),
    PHYSIM_THING(angular_velocity, "steady, about its origin", Quantity::angular_rate),
    PHYSIM_THING(keys, "where it is at rising times, instead of a position and steady motion", at_most(10000)),
    PHYSIM_KEYS("thing.keys"),
    PHYSIM_THING(curve, "which way it takes from key to key"),
    PHYSIM_THING(passage.front,
                 "of a one-way thing, in its own frame: it stops only what comes against this direction"),
    PHYSIM_THING(passage.tells_stay, "of a sensor: an event stayed in each step for what is in it"),
    PHYSIM_THING(conveyor.velocity, "with which its surface runs, in its own frame; the part along the surface acts",
                 Quantity::speed, between(-1e6, 1e6), kShorthand),
};

}  // namespace

std::span<const Entry> scene_settings() { return kSceneSettings; }
std::span<const std::string_view> shape_kinds() { return kind_names<kShapes>(); }

}  // namespace physim
