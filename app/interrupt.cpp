#include "app/interrupt.h"

#include <iterator>

namespace gbl {
namespace {

std::atomic<bool> g_interrupted{false};

void note(int signal) {
  g_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptScope::InterruptScope() {
  g_interrupted = false;
  for (size_t i = 0; i < std::size(kEndings); ++i) before_[i] = std::signal(kEndings[i], note);
}

InterruptScope::~InterruptScope() {
  for (size_t i = 0; i < std::size(kEndings); ++i) std::signal(kEndings[i], before_[i]);
}

const std::atomic<bool>& InterruptScope::interrupted() const { return g_interrupted; }

}  // namespace gbl
