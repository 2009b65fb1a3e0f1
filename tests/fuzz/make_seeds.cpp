// make_seeds FOLDER: for each reader its first corpus, FOLDER/corpus/READER/, and its dictionary, FOLDER/READER.dict: the words in
// quotes of its seeds, and every option and value. Prints the readers' names.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

#include "renderer/options/options.h"
#include "tests/fuzz/readers.h"

namespace gbl::test {
namespace {

void add_quoted_words(const Bytes& bytes, std::set<std::string>& words) {
  std::string word;
  bool within = false;
  for (const uint8_t byte : bytes) {
    if (byte == '"') {
      if (within && !word.empty()) words.insert(word);
      within = !within, word.clear();
    } else if (within) {
      if (byte < 32 || byte > 126 || byte == '\\' || word.size() > 30)
        within = false;
      else
        word += static_cast<char>(byte);
    }
  }
}

std::set<std::string> option_words() {
  std::set<std::string> words;
  for (const Option& o : options()) {
    words.emplace(o.path);
    for (const ValueRow& v : o.values) words.emplace(v.id);
  }
  return words;
}

void write(const std::filesystem::path& folder) {
  for (const Reader& reader : readers()) {
    const std::filesystem::path corpus = folder / "corpus" / reader.name;
    std::filesystem::create_directories(corpus);
    std::set<std::string> words = option_words();
    for (const Seed& seed : reader.seeds()) {
      std::ofstream(corpus / seed.name, std::ios::binary)
          .write(reinterpret_cast<const char*>(seed.bytes.data()), static_cast<std::streamsize>(seed.bytes.size()));
      add_quoted_words(seed.bytes, words);
    }
    std::ofstream dictionary(folder / (std::string(reader.name) + ".dict"));
    for (const std::string& word : words) dictionary << "\"\\\"" << word << "\\\"\"\n";
    std::puts(reader.name);
  }
}

}  // namespace
}  // namespace gbl::test

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_seeds FOLDER\n");
    return 2;
  }
  gbl::test::write(arguments[1]);
}
