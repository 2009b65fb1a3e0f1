// What reads bytes from outside takes its seeds, and takes or refuses everything that is near them.
#include "tests/fuzz/readers.h"

#include <fstream>

#include "renderer/base/random.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl::test {

static void PrintTo(const Reader& r, std::ostream* out) { *out << r.name; }

namespace {

std::string_view text_of(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

class Readers : public testing::TestWithParam<Reader> {};

TEST_P(Readers, TakesItsSeeds) {
  const std::vector<Seed> all = GetParam().seeds();
  ASSERT_FALSE(all.empty());
  for (const Seed& s : all) EXPECT_NO_THROW(GetParam().read(text_of(s.bytes))) << s.name;
}

Bytes bent(Bytes bytes, Pcg32& random) {
  for (uint32_t changes = 1 + random.next() % 4; changes > 0 && !bytes.empty(); --changes) {
    const size_t at = random.next() % bytes.size();
    switch (random.next() % 4) {
      case 0: bytes[at] = static_cast<uint8_t>(random.next()); break;
      case 1: bytes[at] ^= static_cast<uint8_t>(1u << random.next() % 8); break;
      case 2: bytes.erase(bytes.begin() + static_cast<long>(at)); break;
      case 3: {  // a piece once more
        const size_t length = std::min<size_t>(bytes.size() - at, random.next() % 16);
        const Bytes piece(bytes.begin() + static_cast<long>(at), bytes.begin() + static_cast<long>(at + length));
        bytes.insert(bytes.begin() + static_cast<long>(random.next() % bytes.size()), piece.begin(), piece.end());
      }
    }
  }
  return bytes;
}

TEST_P(Readers, TakesOrRefusesBentAndCutFiles) {
  Pcg32 random(3);
  int refused = 0;
  const std::vector<Seed> all = GetParam().seeds();
  for (const Seed& s : all)
    for (size_t round = 0; round < 1 + 200 / all.size(); ++round) {
      refused += takes(GetParam(), text_of(bent(s.bytes, random))) ? 0 : 1;
      takes(GetParam(), text_of(s.bytes).substr(0, random.next() % s.bytes.size()));
    }
  EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Readers, testing::ValuesIn(readers().begin(), readers().end()), [](const auto& of) {
  std::string name = of.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// What the fuzzer once found, kept in tests/fuzz/findings/READER.
TEST(EveryReader, TakesOrRefusesWhatOnceBrokeIt) {
  const std::filesystem::path folder = source_folder() / "tests/fuzz/findings";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "nothing was ever found";
  for (const auto& of_reader : std::filesystem::directory_iterator(folder)) {
    const Reader* reader = reader_named(of_reader.path().filename().string());
    ASSERT_NE(reader, nullptr) << of_reader.path();
    for (const auto& file : std::filesystem::directory_iterator(of_reader)) {
      std::ifstream in(file.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(in), {}};
      std::printf("%s\n", file.path().c_str());  // which of them it was, should it end the program
      takes(*reader, bytes);
    }
  }
}

// What nests without end must not use up the stack.
TEST(EveryReader, TakesOrRefusesWhatNestsWithoutEnd) {
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"lights\":";
  objects += "0" + std::string(100000, '}');
  const std::string arrays = std::string(200000, '[') + std::string(200000, ']');
  for (const Reader& r : readers())
    for (const std::string& text : {arrays, objects}) {
      std::printf("%s\n", r.name);
      takes(r, text);
    }
}

}  // namespace
}  // namespace gbl::test
