// Gallery: the scenarios that ship, in groups of those who may like them, and what a picture of one shows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simclient/core/client.hpp"

namespace physim::client {

/// A scenario that ships.
struct GalleryItem {
  std::string_view scenario;  // its file, without folder and ending
  std::string_view title;     // a few words
};

struct GalleryGroup {
  std::string_view name, doc;
  std::span<const GalleryItem> items;
};

/// Each shipped scenario stands in one of them.
[[nodiscard]] std::span<const GalleryGroup> gallery();
/// Null: no scenario of the gallery has this name.
[[nodiscard]] const GalleryItem* find_in_gallery(std::string_view scenario);
/// Those of a group, or of all where `group` is empty, whose title or name has all words of a text in either case.
[[nodiscard]] std::vector<const GalleryItem*> gallery_items(std::string_view group, std::string_view filter);

/// Opens a scenario of the gallery, and fires what does not fly by itself.
[[nodiscard]] Status open_from_gallery(Client& client, const std::string& scenario);

/// A scenario as its picture shows it: looked at by a camera of this size [pixels], with what flew so far.
struct Pose {
  Client client;
  std::vector<std::vector<TrackSample>> paths;  // of shots that fly whole, in the colours of the palette
};
[[nodiscard]] Result<Pose> pose_of(std::string_view scenario, int width, int height);

}  // namespace physim::client
