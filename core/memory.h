#pragma once

namespace core {

/// Lets large blocks (4 MiB and more) go back to the system when they are freed. By default the GNU C library takes
/// ever larger ones from its heap once some were freed (mallopt(3), M_MMAP_THRESHOLD), where small ones that stay keep
/// it from shrinking: a diagnosis that needs 230 MiB held 1735. Smaller blocks may still stay. To be called once,
/// before threads start; does nothing with other libraries.
void returnLargeBlocks();

}  // namespace core
