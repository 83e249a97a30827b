// The gallery: scenarios that ship as cards with pictures, in groups. A card opens one, and it flies.
#pragma once

#include <string>

#include "simclient/ui/panel.hpp"
#include "simclient/ui/thumbnails.hpp"

namespace physim::client {

class GalleryPanel {
 public:
  void draw(Client& client, const Box& box, float scale);
  [[nodiscard]] Thumbnails& thumbnails() { return thumbnails_; }
  [[nodiscard]] bool is_busy() const { return thumbnails_.is_busy(); }

 private:
  void draw_tabs(Client& client, float scale, bool is_entered);
  /// The scenario that was chosen; null: none.
  [[nodiscard]] const GalleryItem* draw_cards(std::span<const GalleryItem* const> items, float scale);
  [[nodiscard]] bool draw_card(const GalleryItem& item, float width, float scale);

  Thumbnails thumbnails_;
  std::string filter_;
  bool shown_ = false;
};

}  // namespace physim::client
