#include "core/progress.h"

#include "core/error.h"

namespace core {

void stopIfCancelled(const Progress& progress) {
  if (progress.cancelled()) throw Cancelled();
}

}  // namespace core
