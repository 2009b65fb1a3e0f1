#pragma once
// Files, whole or not at all: read with a bound, written by a temporary name. Error says which file and why.
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "renderer/base/error.h"
#include "renderer/base/limits.h"

namespace gbl {

// Error(unfinished) of what follows: there is no room, or no folder. More work would be lost, too.
class CannotWrite : public Error {
 public:
  CannotWrite(const std::filesystem::path&, std::string_view why);
};

// Error(bad_input): cannot be read, is empty, is longer than `most` (a device such as /dev/zero never ends), or is a pipe into
// which nobody writes.
std::string read_text_file(const std::filesystem::path&, size_t most = kMostTextBytes);

// Error(bad_input) if it is there and is no file that is kept on disk: to open a pipe waits for who may never come.
void require_regular(const std::filesystem::path&);

// Error(bad_input) if so small a file cannot hold so much, packed `most_times` as small: the size that a file claims is not to be believed
// before memory is taken for it.
void require_plausible(const std::filesystem::path&, size_t unpacked_bytes, size_t most_times);

// Writes beside the target under a name that nobody else has, and renames once all of it is on disk: nobody ever sees
// half a file, and of two programs that write the same one the last wins. CannotWrite, and the old file stays.
// What a killed program left under such a name goes when the next one writes into that folder.
void write_file(const std::filesystem::path&, const std::function<void(std::FILE*)>& write);
void write_text_file(const std::filesystem::path&, const std::string&);
void make_folder(const std::filesystem::path&);  // and its parents

// What was printed has arrived. Error(unfinished) if not: the disk is full, or nobody reads any more.
void flush_output();

}  // namespace gbl
