#pragma once

#include <string>

#include "specs/project_store.h"

namespace app {

/// Who is at the keyboard (`author`, else $FIDELIS_AUTHOR, else the login name) and the time, in UTC:
/// $SOURCE_DATE_EPOCH if set, so that a build can be repeated byte by byte.
[[nodiscard]] specs::Signature signatureOf(const std::string& author);

}  // namespace app
