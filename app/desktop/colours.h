#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <optional>

#include "percollect/graph.h"
#include "specs/items.h"
#include "specs/proposals.h"
#include "specs/results.h"

namespace desktop {

/// The few colours that are not the palette's. People with any colour vision tell them apart (after Okabe & Ito 2008),
/// and none stands alone: a word, a number or a shape says the same.
namespace accent {
inline const QColor kBlue(0x00, 0x72, 0xb2);
inline const QColor kOrange(0xe6, 0x9f, 0x00);
inline const QColor kTeal(0x00, 0x9e, 0x73);
inline const QColor kRed(0xd5, 0x5e, 0x00);
inline const QColor kPurple(0xa3, 0x38, 0x7c);
}  // namespace accent

[[nodiscard]] bool isDark(const QPalette& palette);
/// `share` of the accent over the palette's base colour: text in the palette's colour stays readable on it.
[[nodiscard]] QColor tint(const QPalette& palette, const QColor& accent, double share);
/// Text of less weight; contrast to the base at least 4.5 : 1.
[[nodiscard]] QColor muted(const QPalette& palette);
/// The accent as colour of text on the base: darkened or lightened until it can be read.
[[nodiscard]] QColor readable(const QPalette& palette, const QColor& accent);
/// Contrast ratio after WCAG 2.1, 1 ... 21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

[[nodiscard]] QPalette lightPalette();
[[nodiscard]] QPalette darkPalette();

[[nodiscard]] QColor colourOf(percollect::NodeKind kind);
[[nodiscard]] QString wordFor(percollect::NodeKind kind);
/// Background of a relevance (2 ... 20) or a score (1 ... 10): the larger, the more orange.
[[nodiscard]] QColor weightColour(const QPalette& palette, int value, int largest);

/// A shape for each status or verdict; colour only helps.
[[nodiscard]] QIcon iconOf(specs::Status status);
[[nodiscard]] QIcon iconOf(specs::Verdict verdict);
[[nodiscard]] QIcon iconOf(specs::ProposalState state);
[[nodiscard]] QIcon warningIcon();
[[nodiscard]] QString wordFor(specs::Kind kind);
[[nodiscard]] QString wordFor(specs::Status status);
[[nodiscard]] QString wordFor(specs::Verdict verdict);
[[nodiscard]] QString wordFor(specs::ProposalState state);

}  // namespace desktop
