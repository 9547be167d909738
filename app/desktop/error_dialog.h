#pragma once

#include <QWidget>
#include <functional>

#include "core/error.h"

namespace desktop {

/// Says what is wrong, where, and what to do about it.
void showError(QWidget* parent, const core::InputError& error);

/// Runs something that may meet a user's mistake; shows it and returns false then.
bool guarded(QWidget* parent, const std::function<void()>& work);

}  // namespace desktop
