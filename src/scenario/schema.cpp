// The tree of tables and keys, and the public face of the list of settings: both made from entries().
#include "scenario/schema.hpp"

#include <algorithm>
#include <memory>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/document.hpp"
#include "scenario/units.hpp"
#include "scenario/writer.hpp"

namespace physim {
namespace {

/// Puts an entry into the tree, making the tables above it where they are not there yet.
void plant(SchemaNode& root, const Entry& entry) {
  PHYSIM_ASSERT(entry.slot != nullptr);
  PHYSIM_ASSERT(!entry.path.empty());
  PHYSIM_ASSERT(!entry.doc.empty());
  PHYSIM_ASSERT(entry.range.low <= entry.range.high);
  PHYSIM_ASSERT((entry.quantity_by == nullptr) == entry.unit_by.empty());
  SchemaNode* node = &root;
  std::string_view rest = entry.path;
  while (!rest.empty()) {
    const std::string_view name = rest.substr(0, rest.find('.'));
    rest.remove_prefix(std::min(name.size() + 1, rest.size()));
    if (entry.shorthand && rest.empty()) node->shorthand = name;
    const SchemaNode* child = node->find(name);
    if (child == nullptr) {
      const std::string path = node->path.empty() ? std::string(name) : node->path + "." + std::string(name);
      node->children.push_back(
          {.name = std::string(name), .path = path, .entry = nullptr, .children = {}, .shorthand = {}});
      child = &node->children.back();
    }
    node = const_cast<SchemaNode*>(child);  // of our own tree
  }
  PHYSIM_ASSERT(node->entry == nullptr);  // no two settings have one path
  node->entry = &entry;
}

/// Lets each node of a tree point to the table that it is in. The tree must stay where it is.
void point_up(SchemaNode& node) {
  for (SchemaNode& child : node.children) child.above = &node, point_up(child);
}

/// Name of each kind of slot, in the order of ValueRef.
constexpr const char* kTypes[] = {"quantity", "quantity", "vector", "vector", "integer", "integer", "boolean",
                                  "text",     "text",     "choice", "points", "points",  "drawn",   "colour",
                                  "gradient", "list",     "list",   "list",   "list",    "list"};
static_assert(std::size(kTypes) == std::variant_size_v<ValueRef>);

std::string range_of(const Entry& entry, const ValueRef& slot) {
  const Choice* choice = std::get_if<Choice>(&slot);
  if (choice == nullptr) return entry.range.text();
  std::string out;
  for (const std::string_view name : choice->names) out += (out.empty() ? "" : " | ") + std::string(name);
  return out;
}

Setting public_setting(const Entry& entry) {
  Defaults defaults;
  const ValueRef slot = entry.slot(defaults.scope());
  return {.path = std::string(entry.path),
          .type = kTypes[slot.index()],
          .quantity = entry.quantity,
          .unit = std::string(entry.quantity_by ? entry.unit_by : si_unit(entry.quantity)),
          .default_value = entry.required ? "" : written(entry, defaults.scope()).value_or(""),
          .range = range_of(entry, slot),
          .doc = std::string(entry.doc),
          .live = entry.live};
}

}  // namespace

const SchemaNode* SchemaNode::find(std::string_view child) const {
  for (const SchemaNode& node : children)
    if (is_same_key(node.name, child)) return &node;
  return nullptr;
}

const SchemaNode& schema() {
  static const std::unique_ptr<const SchemaNode> root = [] {
    auto node = std::make_unique<SchemaNode>();
    for (const Entry& entry : entries()) plant(*node, entry);
    point_up(*node);
    return node;
  }();
  return *root;
}

const SchemaNode* find_node(std::string_view path) {
  const SchemaNode* node = &schema();
  std::size_t begin = 0;
  while (node != nullptr && begin <= path.size()) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    node = node->find(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return node;
}

bool is_of_contact(const SchemaNode& node) {
  return (node.entry != nullptr && node.entry->of_contact) || std::ranges::any_of(node.children, is_of_contact);
}

bool is_of_flights(const SchemaNode& node, const Scenario& scenario) {
  return node.path == "shot.body.colour" || (!scenario.things.empty() && is_of_contact(node));
}

const std::vector<std::string_view>& setting_paths() {
  static const std::vector<std::string_view> paths = [] {
    std::vector<std::string_view> list;
    for (const Entry& entry : entries()) list.push_back(entry.path);
    return list;
  }();
  return paths;
}

std::span<const Setting> settings() {
  const IeeeMode mode;
  static const std::vector<Setting> list = [] {
    std::vector<Setting> all;
    for (const Entry& entry : entries()) all.push_back(public_setting(entry));
    return all;
  }();
  return list;
}

}  // namespace physim
