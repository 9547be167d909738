#include "core/memory.h"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace core {

void returnLargeBlocks() {
#ifdef __GLIBC__
  constexpr int kLarge_bytes = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, kLarge_bytes);  // a fixed one no longer grows
#endif
}

}  // namespace core
