// Pictures and films that SimClient saves: of its window, of the plots, and of the scene without panels.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "simclient/app.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/labels.hpp"
#include "simclient/core/timeline.hpp"
#include "simclient/ui/legend.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

Status save_picture(const Client& client, const Picture& picture, const std::string& path) {
  constexpr std::string_view kCannot = "cannot write";
  const std::string png = png_of(picture);
  if (png.empty()) return Error{"there is no memory for this picture", path, "choose a smaller one: picture-size"};
  const Status status = client.export_file(path, report::as_text(png));
  if (status || !status.error().message.starts_with(kCannot)) return status;
  return Error{"cannot write the picture" + status.error().message.substr(kCannot.size()), path, status.error().hint};
}

/// Restores the settings that a picture replaced.
class ForAPicture {
 public:
  explicit ForAPicture(Client& client)
      : client_(client),
        camera_(client.camera),
        show_(client.show),
        pointer_(client.pointer),
        cursor_(client.cursor),
        quality_(client.quality.now) {
    client.quality.now = Quality::high;
    client.pointer.reset();
    client.cursor.reset();
    client.show.aim = client.session.tracks().empty();  // tracks of what was fired show where it went
  }
  ForAPicture(const ForAPicture&) = delete;
  ForAPicture& operator=(const ForAPicture&) = delete;
  ~ForAPicture() {
    client_.camera = camera_, client_.show = show_;
    client_.pointer = pointer_, client_.cursor = cursor_;
    client_.quality.now = quality_;
  }

 private:
  Client& client_;
  const Camera camera_;
  const Shown show_;
  const std::optional<Pixel> pointer_;
  const std::optional<double> cursor_;
  const Quality quality_;
};

/// A bar as long as a round distance where the view looks, and its length.
void draw_scale_bar(Painter& painter, ImDrawList& list, const Camera& camera, float height, float scale) {
  const double metre = camera.pixel_size(camera.target);
  const double length = scale_step(metre * camera.width() * 0.2, 1.6);
  const auto wide = static_cast<float>(length / metre);
  const float x = 16 * scale, y = height - 18 * scale, tick = 5 * scale;
  const ImU32 colour = shade(colours::kText);
  const std::string text =
      distance_text(length) + (camera.stretch != 1 ? formatted(", heights \u00d7%g", camera.stretch) : "");
  list.AddRectFilled({x - 6 * scale, y - tick - painter.line() - 5 * scale},
                     {x + std::max(wide, painter.width_of(text)) + 6 * scale, y + tick + 3 * scale},
                     exact(theme_in_use().label));
  for (const float end : {x, x + wide}) list.AddLine({end, y - tick}, {end, y + tick}, colour, 2 * scale);
  list.AddLine({x, y}, {x + wide, y}, colour, 2 * scale);
  list.AddText(nullptr, 0, {x, y - tick - painter.line() - 2 * scale}, colour, text.c_str());
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------ pictures
Picture App::picture_of_window(bool of_plots) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  if (!target_) glReadBuffer(GL_BACK);
  if (!of_plots) return read_picture(0, 0, width, height);
  const double part = width / static_cast<double>(ImGui::GetIO().DisplaySize.x);
  const Box& b = ui_->layout().bottom;
  const int top = static_cast<int>(b.y * part), rows = static_cast<int>(b.height * part);
  return read_picture(static_cast<int>(b.x * part), height - top - rows, static_cast<int>(b.width * part), rows);
}

Result<Picture> App::picture_of_scene(const Camera& camera, double scale) {
  const int width = static_cast<int>(camera.width()), height = static_cast<int>(camera.height());
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (std::max(width, height) > most)
    return Error{formatted("a picture of %dx%d pixels is larger than this machine draws (%d)", width, height, most), "",
                 "choose a smaller one: picture-size"};
  const ForAPicture restores(client_);
  client_.camera = camera;
  Scene scene;
  build_scene(client_, scale, scene);
  const Target target(width, height);
  target.bind();
  renderer_.draw(scene, camera, {0, 0, width, height});
  draw_captions(scene, camera, static_cast<float>(scale));
  Picture picture = read_picture(0, 0, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (target_) target_->bind();
  return picture;
}

/// Title, time, labels and a scale bar.
void App::draw_captions(const Scene& scene, const Camera& camera, float scale) {
  const auto width = static_cast<float>(camera.width()), height = static_cast<float>(camera.height());
  ImDrawList& list = painter_.begin(static_cast<int>(width), static_cast<int>(height), scale);
  const float left = 16 * scale, top = 12 * scale;
  const std::string title = painter_.fitting(client_.session.scenario().title, width - 2 * left, Painter::Face::title);
  const std::string time = formatted("%.2f s", client_.session.shown_time());
  const float title_line = painter_.line(Painter::Face::title);
  std::vector<Box> taken = {{left, top, std::max(painter_.width_of(title, Painter::Face::title), 100 * scale),
                             title_line + painter_.line() + 8 * scale},
                            {0, height - 50 * scale, width * 0.3F, 50 * scale}};
  if (scene.legend) taken.push_back(draw_legend(list, *scene.legend, width, 0, scale));
  const auto width_of = [this](const std::string& text) { return painter_.width_of(text); };
  for (const PlacedLabel& each :
       place_labels(scene.labels, camera, {0, 0, width, height}, painter_.line(), scale, width_of, std::move(taken)))
    painter_.write(each.x, each.y, each.label->text, shade(each.label->colour));
  painter_.write(left, top, title, shade(colours::kText), Painter::Face::title);
  painter_.write(left, top + title_line + 4 * scale, time, shade(colours::kText));
  draw_scale_bar(painter_, list, camera, height, scale);
  painter_.end();
}

/// Takes the pictures that were asked for. A failure ends a script; otherwise a message names it.
Status App::take_pictures() {
  const std::vector<PictureWish> wishes = std::move(client_.pictures);
  client_.pictures.clear();
  for (const PictureWish& wish : wishes) {
    const bool is_of_plots = wish.of == PictureOf::plots;
    const bool has_plots = ui_->layout().bottom.height > 0 && client_.bottom == BottomPanel::plots;
    const bool needs_frame = wish.of == PictureOf::window && client_.quality.now != Quality::high;
    if (needs_frame || (is_of_plots && has_plots && !ui_->has_bare_plots())) {  // asked for by a button: the next frame
      client_.pictures.push_back(wish);
      continue;
    }
    const Status status = wish.of == PictureOf::film ? begin_film(wish.path) : take_picture(wish);
    if (!status && options_.hidden) return status;
    if (!status) client_.complain(status.error());
  }
  const bool is_last = client_.leaves || is_last_frame();
  if (!is_last || options_.screenshot.empty()) return {};
  return save_picture(client_, picture_of_window(false), options_.screenshot);
}

Status App::take_picture(const PictureWish& wish) {
  const std::string path = wish.path.empty() ? free_name("picture", ".png") : wish.path;
  const bool has_plots = ui_->layout().bottom.height > 0 && client_.bottom == BottomPanel::plots;
  if (wish.of == PictureOf::plots && !has_plots)
    return Error{"there are no plots to be seen", "picture-of-plots", "open them first: plots"};
  if (Status status = client_.check_output(path); !status) return status;
  if (wish.of != PictureOf::scene) {
    if (Status status = save_picture(client_, picture_of_window(wish.of == PictureOf::plots), path); !status)
      return status;
    return client_.say("saved " + path), Status();
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const int times = client_.picture_size;
  const int width = static_cast<int>(size.x) * times, height = static_cast<int>(size.y) * times;
  const Result<Picture> picture = picture_of_scene(client_.camera_for(width, height), ui_->scale() * times);
  if (!picture) return picture.error();
  if (Status status = save_picture(client_, *picture, path); !status) return status;
  return client_.say(formatted("saved %s, %dx%d pixels", path.c_str(), width, height)), Status();
}

// --------------------------------------------------------------------------------------------------------------- films
/// Of the last seconds as the clock showed them: the session goes back, and comes again picture by picture.
Status App::begin_film(const std::string& wished) {
  constexpr double kWidest = 1920;  // [pixels]
  const std::string path = wished.empty() ? free_name("film", ".mp4") : wished;
  const Timeline line = timeline_of(client_);
  const double speed = client_.session.time_scale();
  Filming next;
  next.begin = std::max({line.begin, line.reachable, line.now - client_.film_length * speed});
  next.each = speed / Film::kRate;
  next.count = static_cast<int>(std::ceil((line.now - next.begin) / next.each - 1e-6)) + 1;
  if (next.count < 2) return Error{"nothing has flown yet that could be filmed", "film", "fire first"};
  if (Status status = client_.check_output(path); !status) return status;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const double part = std::min(1.0, kWidest / static_cast<double>(size.x));
  const auto even = [part](float x) { return 2 * static_cast<int>(std::lround(static_cast<double>(x) * part / 2)); };
  if (Status status = film_.start(path, even(size.x), even(size.y)); !status) return status;
  next.path = path;
  next.camera = client_.camera_for(even(size.x), even(size.y));
  next.scale = ui_->scale() * part;
  next.step = client_.session.step();
  next.was_paused = client_.session.is_paused();
  filming_ = next;
  client_.filmed = 0;
  while (options_.hidden && filming_)
    if (Status status = film_one(); !status) return status;
  return {};
}

Status App::film_one() {
  Filming& now = *filming_;
  const double time = now.begin + now.taken * now.each;
  client_.session.show_at(time);
  client_.advance(0, kInfinity);
  if (now.camera.mode == CameraMode::follow) now.camera.target = client_.camera.target;
  const Result<Picture> picture = picture_of_scene(now.camera, now.scale);
  Status status = picture ? film_.add(*picture) : Status(picture.error());
  ++now.taken;
  client_.filmed = static_cast<double>(now.taken) / now.count;
  if (status && now.taken < now.count && !client_.stops_film) return {};
  return end_film(status);
}

Status App::end_film(Status status) {
  const bool is_given_up = client_.stops_film;
  if (status && !is_given_up) status = film_.finish();
  film_.give_up();
  client_.session.go_to(filming_->step);
  client_.advance(0, kInfinity);
  client_.session.set_paused(filming_->was_paused);
  if (status) client_.say(is_given_up ? "the film was given up" : "saved " + filming_->path);
  filming_.reset();
  client_.filmed.reset();
  client_.stops_film = false;
  return status;
}

}  // namespace physim::client
