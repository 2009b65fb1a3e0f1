#include "renderer/picture/image.h"

#include <fstream>
#include <functional>
#include <iterator>

#include "renderer/base/files.h"
#include "renderer/base/random.h"
#include "tests/gltf/gltf_fixture.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

Image noise(glm::ivec2 size, uint64_t seed) {
  Pcg32 random(seed);
  Image image{size, {}};
  for (int i = 0; i < 4 * size.x * size.y; ++i)
    image.rgba.push_back(i % 4 == 3 ? 255 : static_cast<uint8_t>(random.next()));
  return image;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string from_hex(std::string_view hex) {
  std::string out;
  for (size_t i = 0; i < hex.size(); i += 2)
    out += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return out;
}

int entries(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Png, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder("png");
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {3, 2}, {1, 97}, {257, 1}, {640, 360}}) {
    const Image image = noise(size, 1);
    write_png(folder / "a.png", image);
    EXPECT_TRUE(read_png(folder / "a.png") == image) << size.x << "x" << size.y;
  }
  EXPECT_EQ(entries(folder.path()), 1);  // no temporary file is left
}

// Memory is taken for what a file can hold, not for what it claims.
TEST(Png, ASmallFileCannotClaimAHugePicture) {
  const TemporaryFolder folder("png");
  const test::Bytes claims = test::png(16384, 16384, 8, 2, {1, 2, 3});
  put(folder / "a.png", {reinterpret_cast<const char*>(claims.data()), claims.size()});
  EXPECT_TRUE(
      contains(error_line(ExitCode::bad_input, [&] { read_png(folder / "a.png"); }), "claims 1073741824 bytes"));
}

TEST(Png, AChunkCannotClaimMoreThanTheFile) {
  const TemporaryFolder folder("png");
  const test::Bytes whole = test::png(1, 1, 8, 2, {0, 1, 2, 3});
  std::string bytes(whole.begin(), whole.begin() + 33);  // signature and IHDR
  bytes += from_hex("5c000050") + "tEXt" + std::string(64, 'x');
  put(folder / "a.png", bytes);
  for (const auto& read : {std::function([&] { read_png(folder / "a.png"); }),
                           std::function([&] { read_png_text(folder / "a.png", kSettingsKey); })})
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, read), "is cut short, or no PNG"));
}

TEST(Png, IsOpaqueWhateverTheAlpha) {
  const TemporaryFolder folder("png");
  Image image = noise({16, 16}, 2);
  const Image opaque = image;
  for (size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = static_cast<uint8_t>(i);
  write_png(folder / "a.png", image);
  EXPECT_TRUE(read_png(folder / "a.png") == opaque);
}

TEST(Png, TextsReadBackByTheirKey) {
  const TemporaryFolder folder("png");
  const std::string text = "{\"scene\": \"caf\xc3\xa9\", \"lines\": \"a\\nb\"}\nsecond line " + std::string(20000, 'x');
  write_png(folder / "a.png", noise({4, 4}, 3), {{"Software", "gbufferlab"}, {kSettingsKey, text}});
  EXPECT_EQ(read_png_text(folder / "a.png", kSettingsKey), text);
  EXPECT_EQ(read_png_text(folder / "a.png", "Software"), "gbufferlab");
  EXPECT_EQ(read_png_text(folder / "a.png", "Author"), "");
  EXPECT_TRUE(read_png(folder / "a.png") == noise({4, 4}, 3));
}

TEST(Png, OverwritesWholeAndWritesEqualBytesForEqualPictures) {
  const TemporaryFolder folder("png");
  write_png(folder / "a.png", noise({64, 64}, 4));
  write_png(folder / "a.png", noise({2, 2}, 5));
  write_png(folder / "b.png", noise({2, 2}, 5));
  EXPECT_TRUE(read_png(folder / "a.png") == noise({2, 2}, 5));
  EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));  // no date inside
}

TEST(Png, OtherProgramsKindsAreRead) {
  const TemporaryFolder folder("png");
  const auto pixels = [&](std::string_view hex) {
    put(folder / "a.png", from_hex(hex));
    return read_png(folder / "a.png").rgba;
  };
  // 2x1 grey, one bit a pixel: white, black.
  EXPECT_EQ(pixels("89504e470d0a1a0a0000000d4948445200000002000000010100000000dc5942270000000a49444154789c636800000082"
                   "008177cd72b60000000049454e44ae426082"),
            (std::vector<uint8_t>{255, 255, 255, 255, 0, 0, 0, 255}));
  // 2x1 palette with transparency.
  EXPECT_EQ(
      pixels("89504e470d0a1a0a0000000d4948445200000002000000010803000000c3fc8fb800000006504c54450a141e28323cd51bb4e9"
             "0000000274524e53ff80080fb36a0000000b49444154789c636060040000040002bf7a3f4a0000000049454e44ae426082"),
      (std::vector<uint8_t>{10, 20, 30, 255, 40, 50, 60, 128}));
  // 1x1 RGB of 16 bits: 0x1234, 0x5678, 0x9abc.
  EXPECT_EQ(
      pixels("89504e470d0a1a0a0000000d4948445200000001000000011002000000c0e78f9d0000000f49444154789c63103209ab98b507"
             "000627026b0eded57a0000000049454e44ae426082"),
      (std::vector<uint8_t>{0x12, 0x56, 0x9a, 255}));
}

// ---- files that cannot be read -----------------------------------------------------------------------------

// Reads a file that must give a picture or one Error(bad_input) that names it; true if it gave a picture.
bool reads(const fs::path& path) {
  try {
    read_png(path);
    return true;
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_TRUE(contains(e.what(), path.string())) << e.what();
    return false;
  }
}

TEST(Png, WhatIsNoPngIsBadInput) {
  const TemporaryFolder folder("png");
  EXPECT_FALSE(reads(folder / "missing.png"));
  EXPECT_FALSE(reads(folder.path()));
  for (const char* text : {"", "\x89PNG", "GIF89a and more than eight bytes", "\x89PNG\r\n\x1a\n"}) {
    put(folder / "a.png", text);
    EXPECT_FALSE(reads(folder / "a.png")) << text;
    const auto read_text = [&] { read_png_text(folder / "a.png", kSettingsKey); };
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, read_text), "a.png")) << text;
  }
}

TEST(Png, EveryTruncationIsBadInput) {
  const TemporaryFolder folder("png");
  write_png(folder / "whole.png", noise({9, 7}, 6), {{kSettingsKey, "{\"version\": 1}"}});
  const std::string whole = bytes_of(folder / "whole.png");
  for (size_t size = 0; size < whole.size(); ++size) {
    put(folder / "a.png", std::string_view(whole).substr(0, size));
    EXPECT_FALSE(reads(folder / "a.png")) << size << " of " << whole.size() << " bytes";
  }
}

TEST(Png, AChangedByteIsAPictureOrBadInputNeverACrash) {
  const TemporaryFolder folder("png");
  write_png(folder / "whole.png", noise({9, 7}, 7), {{kSettingsKey, "{\"version\": 1}"}});
  const std::string whole = bytes_of(folder / "whole.png");
  Pcg32 random(8);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string changed = whole;
    changed[random.next() % changed.size()] ^= static_cast<char>(1 + random.next() % 255);
    put(folder / "a.png", changed);
    refused += !reads(folder / "a.png");
    try {
      read_png_text(folder / "a.png", kSettingsKey);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::bad_input);
    }
  }
  EXPECT_GT(refused, 500);  // check sums see nearly all
}

TEST(Png, AClaimOfTerabytesIsRefusedAtOnce) {
  const TemporaryFolder folder("png");
  // The head of a file that claims 1 000 000 x 1 000 000 pixels, its check sum right.
  put(folder / "a.png", from_hex("89504e470d0a1a0a0000000d49484452000f4240000f42400802000000d30faf2a"));
  const std::string line = error_line(ExitCode::bad_input, [&] { read_png(folder / "a.png"); });
  EXPECT_TRUE(contains(line, "Invalid IHDR")) << line;
}

// ---- places that cannot be written -------------------------------------------------------------------------

TEST(Files, APlaceThatCannotBeWrittenIsUnfinishedAndLeavesNothing) {
  const TemporaryFolder folder("files");
  put(folder / "file", "x");
  fs::create_directories(folder / "taken/inside");
  const Image image = noise({2, 2}, 9);
  const int before = entries(folder.path());
  for (const std::string place : {"no-such-folder/a.png", "file/a.png", "taken"}) {
    const fs::path path = folder / place;
    for (const auto& write : std::initializer_list<std::function<void()>>{[&] { write_png(path, image); },
                                                                          [&] { write_text_file(path, "text"); }}) {
      const std::string line = error_line(ExitCode::unfinished, write);
      EXPECT_TRUE(contains(line, path.string() + ": cannot be written")) << line;
      EXPECT_EQ(entries(folder.path()), before) << place;
    }
  }
  error_line(ExitCode::unfinished, [&] { make_folder(folder / "file"); });
  error_line(ExitCode::unfinished, [&] { make_folder(folder / "file/below"); });
}

TEST(Files, AFolderWithoutWritePermissionIsUnfinished) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder("files");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  error_line(ExitCode::unfinished, [&] { write_text_file(folder / "a.txt", "text"); });
  EXPECT_EQ(entries(folder.path()), 0);
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(Files, AFailedWriteKeepsTheOldFile) {
  const TemporaryFolder folder("files");
  write_text_file(folder / "a.png", "old");
  error_line(ExitCode::unfinished, [&] { write_png(folder / "a.png", Image{}); });  // a PNG has at least one pixel
  EXPECT_EQ(bytes_of(folder / "a.png"), "old");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Files, TextIsWrittenToTheByteAndFoldersWithTheirParents) {
  const TemporaryFolder folder("files");
  make_folder(folder / "a/b/c");
  make_folder(folder / "a/b/c");  // again: it is there
  const std::string text("line\r\n\0binary \xff", 15);
  for (const std::string& t : {text, std::string()}) {
    write_text_file(folder / "a/b/c/t.txt", t);
    EXPECT_EQ(bytes_of(folder / "a/b/c/t.txt"), t);
  }
  EXPECT_EQ(entries(folder / "a/b/c"), 1);
}

TEST(GlRows, AreFlippedForOddAndEvenHeights) {
  for (const int height : {1, 2, 3, 4, 5}) {
    std::vector<uint8_t> rows;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < 8; ++x) rows.push_back(static_cast<uint8_t>(10 * y + x));
    const Image image = image_from_gl_rows({2, height}, rows);
    EXPECT_EQ(image.size, glm::ivec2(2, height));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < 8; ++x) EXPECT_EQ(image.rgba[8 * y + x], 10 * (height - 1 - y) + x) << height;
  }
}

TEST(Png16, KeepsSixteenBitsOfAChannel) {
  const TemporaryFolder folder("png16");
  const std::vector<glm::vec3> rgb = {{0, 0.5f, 1}, {-1, 2, std::nanf("")}, {0.25f, 1.0f / 65535, 256.0f / 65535}};
  write_png16(folder / "a.png", {3, 1}, rgb, {{"gbufferlab-range", "0 1"}});
  const std::string bytes = bytes_of(folder / "a.png");
  EXPECT_EQ(bytes[24], 16) << "the header's bit depth";
  EXPECT_EQ(read_png_text(folder / "a.png", "gbufferlab-range"), "0 1");
  const Image high = read_png(folder / "a.png");  // the reader keeps the high byte
  const std::vector<uint8_t> expected = {0, 128, 255, 255, 0, 255, 0, 255, 64, 0, 1, 255};
  EXPECT_EQ(high.rgba, expected);
}

}  // namespace
}  // namespace gbl
