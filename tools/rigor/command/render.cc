// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor render`: pictures of models, without a window.

#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/path.h>
#include <rigor/view/image/compose.h>

#include "command/command.h"
#include "model/model_file.h"
#include "model/render_model.h"
#include "option/search.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

using view::View;

constexpr PictureOptions kOnePicture{960, 640, 0};
constexpr PictureOptions kOfASheet{320, 240, 0};
constexpr PictureOptions kThumbnail{640, 480, 0};

/// As Gazebo makes the pictures of a model's folder `thumbnails`: 1.png, 2.png…
constexpr std::array kThumbnailViews{View::kPerspective, View::kTop, View::kFront, View::kSide,
                                     View::kBack};
/// Of `--view all`.
constexpr std::array kAllViews{View::kPerspective, View::kFront, View::kSide, View::kTop};

/// Of what is not drawn: a model whose package is not found lacks everything for one reason.
constexpr std::size_t kMaxSaid = 10;
constexpr std::size_t kMaxSaidOnASheet = 1;

/// More are no picture: each takes its place in memory.
constexpr std::size_t kMaxModels = 2000;

std::uint32_t picture_side(std::string_view text, const std::string& whole) {
  std::uint32_t side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc() || end != text.data() + text.size() || side == 0) {
    throw UsageError("--size " + whole + ": it is WIDTHxHEIGHT in pixels, as 960x640");
  }
  return side;
}

class Render final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "render", "Render images, without a window or a graphics card",
        {"rigor render my_robot -o my_robot.png",
         "rigor render arm.urdf -o arm.png --joint elbow=1.2",
         "rigor render my_robot -o inside.png --show visual,inertia,com --view "
         "side",
         "rigor render new.sdf --compare old.sdf -o review.png", "rigor render models -o sheet.png",
         "rigor render my_robot --view thumbnails -o my_robot/thumbnails"});
    app->add_option("models", paths_,
                    "Model files, or folders; of several models, all are put "
                    "on one sheet")
        ->required()
        ->type_name("MODEL");
    app->add_option("-o,--out", out_, "The image, a PNG; with --view thumbnails, the folder")
        ->required()
        ->type_name("FILE");
    offer(app->add_option("--view", view_,
                          "perspective (the default), front, side, top, back, all or "
                          "thumbnails")
              ->type_name("VIEW"),
          known_views());
    app->add_option("--size", size_,
                    "Of the image, in pixels, default 960x640; of each on a "
                    "sheet, 320x240")
        ->type_name("WxH");
    offer(app->add_option("--show", show_,
                          "Layers, default visual,ground; known are " + listed(view::layer_names()))
              ->type_name("LAYERS"),
          view::layer_names());
    app->add_option("--joint", joints_, "Position of a joint, rad or m; VALUE,VALUE for two axes")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app->add_option("--compare", compare_, "Show this older model next to it, and the differences")
        ->type_name("OLD");
    app->add_option("--threads", threads_, "How many cores to use, default all")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::set<view::Layer> layers = asked_layers();
    const std::vector<std::string_view> views = known_views();
    const std::string_view view = views[choice("view", view_, views)];
    const GuardedDisk disk = search_.disk(named_paths());
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    const std::vector<std::string> files = models(environment);
    ModelPainter painter(disk, environment);
    if (files.size() > 1) return render_sheet(painter, files, layers, view);

    const DrawnModel drawn = painter.draw(files.front(), joints_, layers);
    say_what_is_missing(drawn, kMaxSaid);
    if (!compare_.empty()) return render_comparison(painter, drawn, layers, view);
    if (!drawn.problem.empty()) return kFindings;
    if (view == "thumbnails") return render_thumbnails(painter, drawn.drawing);
    if (view == "all") return render_all_views(painter, drawn.drawing);
    write_picture(out_, painter.picture(drawn.drawing, *view::view_named(view), size(kOnePicture)));
    return kClean;
  }

 private:
  static std::vector<std::string_view> known_views() {
    std::vector<std::string_view> views = view::view_names();
    views.emplace_back("all");
    views.emplace_back("thumbnails");
    return views;
  }

  std::set<view::Layer> asked_layers() const {
    std::set<view::Layer> layers;
    const std::vector<std::string_view> known = view::layer_names();
    const std::string_view text = show_;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string_view name = text.substr(begin, end - begin);
      layers.insert(*view::layer_named(known[choice("layer", name, known)]));
      begin = end + 1;
    }
    return layers;
  }

  PictureOptions size(PictureOptions otherwise) const {
    otherwise.threads = threads_;
    if (size_.empty()) return otherwise;
    const std::size_t times = std::min(size_.find('x'), size_.size());
    const std::string_view text = size_;
    otherwise.width = picture_side(text.substr(0, times), size_);
    otherwise.height = picture_side(text.substr(std::min(times + 1, text.size())), size_);
    if (otherwise.width > view::kMaxPixels / otherwise.height) {
      throw UsageError("--size " + size_ + ": over " + std::to_string(view::kMaxPixels) +
                       " pixels");
    }
    return otherwise;
  }

  std::vector<std::string> named_paths() const {
    std::vector<std::string> named = paths_;
    if (!compare_.empty()) named.push_back(compare_);
    return named;
  }

  std::vector<std::string> models(const Environment& environment) const {
    for (const std::string& path : paths_) {
      if (environment.disk.kind(path) == PathKind::kMissing)
        throw UsageError(path + ": no such file or folder");
    }
    std::vector<std::string> all = model_paths(environment, paths_);
    if (all.empty()) throw UsageError("there is no model to draw");
    if (all.size() > kMaxModels) {
      throw UsageError(report::counted(all.size(), "model") + ": no sheet holds more than " +
                       std::to_string(kMaxModels));
    }
    return all;
  }

  static std::string png_of(const view::Picture& picture) {
    if (picture.pixels.empty()) throw UsageError("the image would be too large");
    return view::to_png(picture);
  }

  static void write_picture(const std::string& path, const view::Picture& picture) {
    replace_file(path, png_of(picture));
  }

  int render_all_views(const ModelPainter& painter, const view::Drawing& drawing) const {
    PictureOptions each = size(kOnePicture);
    each.width = std::max(each.width / 2, 1U);
    each.height = std::max(each.height / 2, 1U);
    std::vector<view::Tile> tiles;
    for (const View view : kAllViews) {
      tiles.push_back({painter.picture(drawing, view, each), std::string(to_string(view))});
    }
    write_picture(out_, view::sheet(tiles, 2));
    return kClean;
  }

  int render_thumbnails(const ModelPainter& painter, const view::Drawing& drawing) const {
    std::error_code error;
    std::filesystem::create_directories(out_, error);
    if (error) throw UsageError(out_ + ": cannot be created: " + error.message());
    int number = 0;
    for (const View view : kThumbnailViews) {
      const std::string name = std::to_string(++number) + ".png";
      put_file(out_, name, png_of(painter.picture(drawing, view, size(kThumbnail))));
    }
    return kClean;
  }

  int render_comparison(ModelPainter& painter, const DrawnModel& now,
                        const std::set<view::Layer>& layers, std::string_view name) const {
    const std::optional<View> view = view::view_named(name);
    if (!view)
      throw UsageError("--compare needs one view: --view " + std::string(name) + " has several");
    const DrawnModel old = painter.draw(compare_, joints_, layers);
    say_what_is_missing(old, kMaxSaid);
    if (!now.problem.empty() && !old.problem.empty()) return kFindings;
    const mesh::Bounds bounds = around(old.drawing.bounds, now.drawing.bounds);
    const PictureOptions options = size({480, 400, 0});
    view::Picture before = painter.picture(old.drawing, *view, bounds, options);
    view::Picture after = painter.picture(now.drawing, *view, bounds, options);
    const view::Picture gray_before =
        painter.picture(view::in_gray(old.drawing), *view, bounds, options);
    const view::Picture gray_after =
        painter.picture(view::in_gray(now.drawing), *view, bounds, options);
    const std::size_t pixels = view::count_differences(before, after);
    const bool shapes = view::count_differences(gray_before, gray_after) > 0;
    view::Picture marked = view::difference({before, after, gray_before, gray_after});
    const std::string what = pixels == 0 ? "no difference"
                             : shapes    ? "red: shapes, blue: colors only"
                                         : "blue: colors only";
    write_picture(out_, view::sheet({{std::move(before), compare_},
                                     {std::move(after), now.path},
                                     {std::move(marked), what}},
                                    3));
    say(pixels == 0 ? "rigor: the images are the same"
                    : "rigor: the images differ in " + report::counted(pixels, "pixel") +
                          (shapes ? "" : ", in their colors only"));
    return kClean;
  }

  int render_sheet(ModelPainter& painter, const std::vector<std::string>& files,
                   const std::set<view::Layer>& layers, std::string_view name) const {
    const std::optional<View> view = view::view_named(name);
    if (!view || !compare_.empty() || !joints_.empty()) {
      const std::string what = !view ? "this --view" : joints_.empty() ? "--compare" : "--joint";
      throw UsageError(what + " is for one model, and there are " + std::to_string(files.size()));
    }
    const PictureOptions options = size(kOfASheet);
    std::vector<view::Tile> tiles;
    bool all = true;
    for (const std::string& file : files) {
      const std::optional<DrawnModel> drawn = drawn_for_sheet(painter, file, layers);
      if (!drawn || !drawn->problem.empty()) {
        all = false;
        continue;
      }
      tiles.push_back({painter.picture(drawn->drawing, *view, options), caption_of(file)});
    }
    if (tiles.empty()) return kFindings;
    const std::size_t columns = view::columns_for(tiles.size(), options.width, options.height);
    write_picture(out_, view::sheet(tiles, columns));
    return all ? kClean : kFindings;
  }

  /// One that cannot be read takes nothing from the others.
  static std::optional<DrawnModel> drawn_for_sheet(ModelPainter& painter, const std::string& file,
                                                   const std::set<view::Layer>& layers) {
    try {
      DrawnModel drawn = painter.draw(file, {}, layers);
      say_what_is_missing(drawn, kMaxSaidOnASheet);
      return drawn;
    } catch (const UsageError& error) {
      say("rigor: " + report::printable(error.what()));
      return std::nullopt;
    }
  }

  /// Of "robots/arm/model.sdf", "arm", since all are called so.
  static std::string caption_of(std::string path) {
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    const std::string_view name = file_name(path);
    const bool general = name.starts_with("model.") || name.starts_with("model-");
    return std::string(general ? file_name(parent_path(path)) : name);
  }

  std::vector<std::string> paths_;
  std::string out_;
  std::string view_ = "perspective";
  std::string size_;
  std::string show_ = "visual,ground";
  std::string compare_;
  std::vector<std::string> joints_;
  unsigned threads_ = 0;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> render_command() { return std::make_unique<Render>(); }

}  // namespace rigor::tool
