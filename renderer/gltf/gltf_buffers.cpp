#include <fmt/format.h>

#include "renderer/gltf/gltf_document.h"

namespace gbl::gltf {

void load_buffers(Document& document, std::vector<Source>& sources, std::span<const uint8_t> chunk, bool has_chunk,
                  Folder& folder, Job& job) {
  document.buffers.resize(sources.size());
  document.owned.reserve(sources.size());  // spans point into its elements' bytes
  for (size_t i = 0; i < sources.size(); ++i) try {
      Source& source = sources[i];
      if (source.uri.empty() && i == 0 && has_chunk) {
        document.buffers[0] = chunk;  // specification 4.4.3: the first buffer without a URI is the chunk
      } else {
        if (source.uri.empty()) throw Broken("it has neither a URI nor a chunk in this file");
        document.owned.push_back(is_data_uri(source.uri) ? decode_data_uri(source.uri) : folder.read(source.uri));
        document.buffers[i] = document.owned.back();
      }
      std::string().swap(source.uri);
      if (document.buffers[i].size() < source.byte_length)
        throw Broken(
            fmt::format("it should have {} bytes, but has {}", source.byte_length, document.buffers[i].size()));
      document.buffers[i] = document.buffers[i].first(source.byte_length);
    } catch (const Broken& broken) {
      document.buffers[i] = {};
      job.note(fmt::format("buffers[{}]: {}; what is in it is not drawn", i, broken.what()));
    }
}

}  // namespace gbl::gltf
