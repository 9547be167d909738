#include "core/memory.h"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace core {

void returnLargeBlocks() {
#ifdef __GLIBC__
  // Smaller ones would come back at once: with 256 KiB a diagnosis spent a quarter of its time on pages.
  constexpr int kLarge_bytes = 4 * 1024 * 1024;
  mallopt(M_MMAP_THRESHOLD, kLarge_bytes);  // a fixed one no longer grows
#endif
}

}  // namespace core
