#include "app/desktop/guarded_work.h"

#include <exception>

#include "core/progress.h"

namespace desktop {

std::optional<core::InputError> errorOf(const std::function<void()>& work, const std::filesystem::path& file,
                                        const std::string& remedy) {
  try {
    work();
  } catch (const core::InputError& mistake) {
    return mistake;
  } catch (const core::Cancelled&) {
    // Nothing is left behind; the window says so.
  } catch (const std::exception& other) {
    return core::InputError({.file = file}, std::string("internal error: ") + other.what(), remedy);
  }
  return std::nullopt;
}

}  // namespace desktop
