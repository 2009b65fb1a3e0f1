#pragma once
// The window: events in, one UI frame, whatever it asks for, picture out.
#include <memory>
#include <optional>

#include "app/commands.h"

namespace gbl {

class LabWindow {
 public:
  // Says how far it is while it reads what it starts with. Error as commands throw it.
  explicit LabWindow(const Arguments&);
  ~LabWindow();

  bool step();  // one frame; false: it was closed
  void keep();  // what the next window goes on with

  struct Probed {
    glm::ivec2 pixel, size;  // of the picture, from its top left
  };
  std::optional<Probed> probed() const;  // the pixel that is held or pointed at

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace gbl
