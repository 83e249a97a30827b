// Files are read whole within a limit; what has no end is refused by every door that reads one.
#include "scenario/text_file.hpp"

#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <thread>

#include "cli/program.hpp"
#include "physim/scenario.hpp"
#include "scenario/measured_column.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_text_file_test {

using testing_cli::Folder;
using testing_cli::has;

constexpr std::uintmax_t kSmall = 4096;

std::string pipe_in(const Folder& folder, const std::string& name) {
  EXPECT_EQ(mkfifo((folder / name).c_str(), 0600), 0);
  return folder / name;
}

/// Writes into a pipe once somebody reads it.
std::thread writer_of(const std::string& pipe, std::string text) {
  return std::thread([pipe, text = std::move(text)] {
    signal(SIGPIPE, SIG_IGN);
    const int out = open(pipe.c_str(), O_WRONLY);
    for (std::size_t from = 0; from < text.size();) {
      const ssize_t count = write(out, text.data() + from, text.size() - from);
      if (count <= 0) break;  // nobody reads any more
      from += static_cast<std::size_t>(count);
    }
    close(out);
  });
}

TEST(TextFile, IsReadToItsEnd) {
  const Folder folder;
  for (const std::size_t size : {0, 1, 4095, 4096}) {
    const std::string text(size, 'x');
    const auto read = must(read_text_file(folder.write("a", text), kSmall, "list"), size);
    EXPECT_EQ(read, text) << size;
  }
  const std::string large = folder.write("large", std::string(4097, 'x'));
  EXPECT_EQ(read_text_file(large, kSmall, "list").error().text(),
            large + ": error: larger than 4 KiB; this cannot be a list");
  EXPECT_FALSE(check_file(large, kSmall, "list"));
  EXPECT_TRUE(check_file(large, 4097, "list"));
  const std::string bytes = std::string("a\0b", 3);
  ASSERT_EQ(read_byte_file(folder.write("b", bytes), kSmall, "list")->size(), 3U);
}

TEST(TextFile, IsTextInUtf8WithoutItsMarks) {
  const Folder folder;
  const auto text = [&](const std::string& bytes) { return read_text_file(folder.write("a", bytes), kSmall, "list"); };
  EXPECT_EQ(must(text("\xef\xbb\xbf"
                      "a\n\x1a")),
            "a\n");
  EXPECT_EQ(must(text(std::string("a\0\x1a", 3))), std::string("a\0\x1a", 3)) << "numbers in bytes";
  for (const std::string& wide : {std::string("\xff\xfe"
                                              "a\0",
                                              4),
                                  std::string("\xfe\xff"
                                              "\0a",
                                              4)})
    EXPECT_EQ(text(wide).error().text(), (folder / "a") + ":1:1: error: the text is in UTF-16; save it as UTF-8");
}

TEST(TextFile, HasLinesThatEndInThreeWays) {
  std::string_view text = "a\n\nb\r\n\r\nc\r\rd";
  std::vector<std::string_view> lines;
  while (!text.empty()) lines.push_back(take_line(text));
  EXPECT_EQ(lines, (std::vector<std::string_view>{"a", "", "b", "", "c", "", "d"}));
}

TEST(TextFile, SaysWhatStandsThere) {
  const Folder folder;
  const auto refusal = [&](const std::string& file) { return read_text_file(file, kSmall, "list").error().text(); };
  EXPECT_EQ(refusal(folder / "none"), folder / "none" + ": error: there is no such file");
  EXPECT_EQ(refusal(folder / ""), folder / "" + ": error: this is a folder; name a list in it");
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: error: this is a device, which has no end of its own; name a list");
  std::filesystem::create_symlink("/dev/zero", folder / "link");
  EXPECT_TRUE(has(refusal(folder / "link"), "this is a device"));
  sockaddr_un at{.sun_family = AF_UNIX, .sun_path = {}};
  const std::string socket_path = folder / "s";
  ASSERT_LT(socket_path.size(), sizeof at.sun_path);
  socket_path.copy(at.sun_path, socket_path.size());
  const int bound = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(bound, reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  EXPECT_TRUE(has(refusal(socket_path), "this is a socket"));
  close(bound);
}

TEST(TextFile, OfAPipeEndsToo) {
  const Folder folder;
  const std::string pipe = pipe_in(folder, "p");
  EXPECT_TRUE(has(check_file(pipe, kSmall, "list").error().text(), "this is a pipe"));
  EXPECT_EQ(read_text_file(pipe, kSmall, "list").error().text(),
            pipe + ": error: nobody writes into this pipe; name a list");
  std::thread writer = writer_of(pipe, std::string(4096, 'y'));
  const auto read = must(read_text_file(pipe, kSmall, "list"));
  writer.join();
  EXPECT_EQ(read, std::string(4096, 'y'));
  std::thread endless = writer_of(pipe, std::string(1 << 20, 'y'));
  EXPECT_TRUE(has(read_text_file(pipe, kSmall, "list").error().text(), "larger than 4 KiB"));
  endless.join();
}

/// Every door of the library that reads a file; each says that a device is none.
TEST(TextFile, WithoutAnEndIsRefusedByEveryDoor) {
  const Folder folder;
  const std::string device = "/dev/zero";
  EXPECT_TRUE(has(load_scenario(device).error().text(), "this is a device"));
  EXPECT_TRUE(has(read_motor_file(device).error().text(), "this is a device"));
  EXPECT_TRUE(has(load_recording(device).error().text(), "this is a device"));
  EXPECT_TRUE(
      has(read_measured_column(device, "speed", Quantity::speed, Measured::values).error().text(), "this is a device"));
  if (reads_mesh_files()) {
    EXPECT_TRUE(has(read_mesh_file(device).error().text(), "this is a device"));
  }
  if (reads_height_maps()) {
    EXPECT_TRUE(has(read_height_map(device, 0, 1).error().text(), "this is a device"));
  }
  if (reads_terrain_files()) {
    EXPECT_TRUE(has(read_terrain_file(device).error().text(), "this is a device"));
  }
  // What a mesh names is a file as well, or is left out.
  if (!reads_mesh_files()) return;
  const std::string triangle = "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
  pipe_in(folder, "m.mtl");
  const auto mesh = must(read_mesh_file(folder.write("m.obj", "mtllib m.mtl" + triangle)));
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

}  // namespace physim::scenario_text_file_test
