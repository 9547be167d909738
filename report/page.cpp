#include "report/page.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "core/version.h"

namespace report {

namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; color: #1f2328;
  background: #fff; margin: 0 auto; padding: 28px 32px 48px; max-width: 1000px; }
header { border-bottom: 3px solid #0072b2; padding-bottom: 12px; margin-bottom: 18px; }
h1 { font-size: 26px; line-height: 1.25; margin: 0; }
h2 { font-size: 20px; margin: 34px 0 10px; padding-bottom: 4px; border-bottom: 1px solid #d8dde3; }
h3 { font-size: 16px; margin: 24px 0 8px; }
h2 .badge, h3 .badge { margin-left: 8px; vertical-align: 2px; }
p { margin: 8px 0; max-width: 75ch; }
.subtitle { color: #59636e; margin: 4px 0 0; }
.banner { max-width: none; padding: 10px 14px; margin: 0 0 14px; border-left: 5px solid; font-weight: 600; }
.badge { display: inline-block; padding: 0 9px; border-radius: 10px; border: 1px solid; font-size: 12.5px;
  font-weight: 600; letter-spacing: .02em; white-space: nowrap; }
.good { color: #14532d; background: #e3f4e7; border-color: #2e7d32; }
.bad { color: #7f1d1d; background: #fde8e8; border-color: #b3261e; }
.warning { color: #6b4700; background: #fff4d6; border-color: #c98a00; }
.neutral { color: #3d4650; background: #eef1f4; border-color: #8b949e; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Consolas, monospace; font-size: 13px;
  overflow-wrap: anywhere; }
pre { background: #f6f8fa; border: 1px solid #d8dde3; padding: 10px 12px; white-space: pre-wrap; }
table { border-collapse: collapse; margin: 10px 0 16px; width: 100%; font-size: 14px; }
th, td { text-align: left; vertical-align: top; padding: 5px 10px; border-bottom: 1px solid #e3e6ea; }
thead th { border-bottom: 2px solid #8b949e; font-size: 13px; color: #3d4650; }
tbody tr:nth-child(even) { background: #f8f9fb; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
table.facts th { width: 11em; font-weight: 600; color: #3d4650; white-space: nowrap; }
table.facts tr { background: none; }
figure { margin: 14px 0 20px; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; border: 1px solid #e3e6ea; }
.answer { border: 2px solid #0072b2; border-radius: 6px; padding: 4px 20px 10px; margin: 0 0 18px; background: #f4f9fd; }
.answer h2 { margin: 12px 0 4px; border: 0; font-size: 16px; }
.answer .sentence { font-size: 19px; line-height: 1.4; font-weight: 600; max-width: none; margin: 4px 0 12px; }
dl { display: grid; grid-template-columns: 11.5em 1fr; gap: 8px 16px; margin: 10px 0; }
dt { font-weight: 600; color: #3d4650; } dd { margin: 0; max-width: 75ch; } dd p:first-child, dd ol { margin-top: 0; }
dd ol { margin-bottom: 0; padding-left: 1.3em; } li { margin: 3px 0; max-width: 75ch; }
.lead { color: #3d4650; font-style: italic; }
.scroll { overflow-x: auto; } caption { text-align: left; color: #59636e; font-size: 13.5px; padding: 4px 0; }
thead th.number { white-space: normal; } tbody th { font-weight: 400; }
.share { white-space: nowrap; } .share svg { vertical-align: 0; border-radius: 2px; }
.shaded { display: block; padding: 2px 8px; text-align: center; }
figcaption { color: #59636e; font-size: 13.5px; max-width: 85ch; }
nav { background: #f6f8fa; border: 1px solid #e3e6ea; padding: 8px 14px; margin: 14px 0; }
nav ul { margin: 0; padding-left: 18px; columns: 2; }
details { margin: 8px 0; } summary { cursor: pointer; color: #0b4f7d; font-weight: 600; }
a { color: #0b4f7d; }
footer { margin-top: 40px; padding-top: 8px; border-top: 1px solid #d8dde3; color: #59636e; font-size: 13px; }
@media screen and (prefers-color-scheme: dark) { body { background: #16191d; color: #e3e6ea; }
  h2 { border-color: #3d4650; } a, summary { color: #7cc0f0; } nav, pre { background: #1f2429; border-color: #3d4650; }
  .answer { background: #1a232b; } dt, thead th, table.facts th, .lead { color: #c3cad2; }
  .subtitle, figcaption, caption, footer { color: #a5aeb8; } th, td { border-color: #343b43; }
  tbody tr:nth-child(even) { background: #1d2126; } figure svg { background: #fff; }
  .good { color: #b7e4c0; background: #14351d; } .bad { color: #f7c1bd; background: #47191a; }
  .warning { color: #f5d78a; background: #3d2f0a; } .neutral { color: #d5dae0; background: #2d333a; } }
@media print { :root { color-scheme: light; } .scroll { overflow: visible; } .answer, .shaded, .share {
  print-color-adjust: exact; -webkit-print-color-adjust: exact; break-inside: avoid; }
  body { padding: 0; max-width: none; font-size: 11pt; } h2, h3 { break-after: avoid; }
  tr { break-inside: avoid; } .badge, .banner, tbody tr { print-color-adjust: exact;
  -webkit-print-color-adjust: exact; } nav { display: none; } }
)";

std::string_view className(Tone tone) {
  switch (tone) {
    case Tone::Good:
      return "good";
    case Tone::Bad:
      return "bad";
    case Tone::Warning:
      return "warning";
    case Tone::Neutral:
      break;
  }
  return "neutral";
}

/// Escaped for XML 1.0: control characters, which it cannot hold at all, become the replacement character.
std::string escaped(std::string_view text) {
  std::string clean;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 && c != '\n' && c != '\t') {
      clean += "\xEF\xBF\xBD";
    } else {
      clean += c;
    }
  }
  return core::escapeMarkup(clean);
}

std::string idAttribute(std::string_view anchor) {
  return anchor.empty() ? std::string() : fmt::format(" id=\"{}\"", escaped(anchor));
}

}  // namespace

Html rawHtml(std::string markup) { return Html(std::move(markup)); }
Html text(std::string_view text) { return rawHtml(escaped(text)); }
Html code(std::string_view text) { return rawHtml("<code>" + escaped(text) + "</code>"); }
Html strong(std::string_view text) { return rawHtml("<strong>" + escaped(text) + "</strong>"); }

Html badge(std::string_view word, Tone tone) {
  return rawHtml(fmt::format("<span class=\"badge {}\">{}</span>", className(tone), escaped(word)));
}

Html link(std::string_view address, std::string_view text) {
  return rawHtml(fmt::format("<a href=\"{}\">{}</a>", escaped(address), escaped(text)));
}

Html shareBar(double share) {
  const double width = 60.0 * std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0);
  return rawHtml(
      fmt::format("<span class=\"share\"><svg width=\"60\" height=\"9\" aria-hidden=\"true\"><rect width=\"60\" "
                  "height=\"9\" fill=\"#d8dde3\"/><rect width=\"{:.1f}\" height=\"9\" fill=\"#0072b2\"/></svg> {:.0f} "
                  "%</span>",
                  width, 100.0 * share));
}

Html shaded(std::string_view number, double share) {
  share = std::clamp(share, 0.0, 1.0);  // squared below: what is hardly alike stays pale
  return rawHtml(fmt::format("<span class=\"shaded\" style=\"background:rgba(86,180,233,{:.2f})\">{}</span>",
                             0.9 * share * share, escaped(number)));
}

Html orderedList(const std::vector<Html>& items) {
  std::string markup = "<ol>\n";
  for (const Html& item : items) markup += "<li>" + item.markup() + "</li>\n";
  return rawHtml(markup + "</ol>\n");
}

Html definitions(const std::vector<Definition>& entries) {
  std::string markup = "<dl>\n";
  for (const Definition& entry : entries) {
    markup += fmt::format("<dt{}>{}</dt><dd>{}</dd>\n", idAttribute(entry.anchor), escaped(entry.term),
                          entry.meaning.markup());
  }
  return rawHtml(markup + "</dl>\n");
}

Html operator+(Html left, const Html& right) {
  left += right;
  return left;
}

Page::Page(std::string_view title, std::string_view subtitle) : title_(title), subtitle_(subtitle) {}

void Page::banner(std::string_view text, Tone tone) {
  banners_ += fmt::format("<p class=\"banner {}\" role=\"note\">{}</p>\n", className(tone), escaped(text));
}

void Page::answer(std::string_view heading, const Html& badge, std::string_view sentence,
                  const std::vector<KeyValue>& facts) {
  answer_ += fmt::format(
      "<section class=\"answer\" id=\"answer\" aria-labelledby=\"answer-heading\">\n<h2 "
      "id=\"answer-heading\">{}{}</h2>\n"
      "<p class=\"sentence\">{}</p>\n<dl>\n",
      escaped(heading), badge.markup(), escaped(sentence));
  for (const KeyValue& fact : facts)
    answer_ += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(fact.key), fact.value.markup());
  answer_ += "</dl>\n</section>\n";
}

void Page::heading(int level, std::string_view title, std::string_view anchor, const Html& after) {
  body_ += fmt::format("<h{0}{1}>{2}{3}</h{0}>\n", level, idAttribute(anchor), escaped(title), after.markup());
}

void Page::section(std::string_view title, std::string_view anchor) { section(title, anchor, text("")); }

void Page::section(std::string_view title, std::string_view anchor, const Html& after) {
  if (!anchor.empty()) contents_.push_back({std::string(anchor), std::string(title)});
  heading(2, title, anchor, after);
}

void Page::subsection(std::string_view title, std::string_view anchor) { heading(3, title, anchor, text("")); }

void Page::subsection(std::string_view title, std::string_view anchor, const Html& after) {
  heading(3, title, anchor, after);
}

void Page::paragraph(std::string_view content) { paragraph(text(content)); }

void Page::paragraph(const Html& content) { body_ += "<p>" + content.markup() + "</p>\n"; }

void Page::lead(std::string_view content) { body_ += "<p class=\"lead\">" + escaped(content) + "</p>\n"; }

void Page::block(const Html& content) { body_ += content.markup(); }

void Page::keyValues(const std::vector<KeyValue>& rows) {
  body_ += "<table class=\"facts\"><tbody>\n";
  for (const KeyValue& row : rows) {
    body_ += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escaped(row.key), row.value.markup());
  }
  body_ += "</tbody></table>\n";
}

void Page::table(const std::vector<TableColumn>& header, const std::vector<std::vector<Html>>& rows,
                 std::string_view caption) {
  const auto classOf = [&](std::size_t i) { return header[i].align == Align::Right ? " class=\"number\"" : ""; };
  body_ += "<div class=\"scroll\"><table>";
  if (!caption.empty()) body_ += "<caption>" + escaped(caption) + "</caption>";
  body_ += "<thead><tr>";
  for (std::size_t i = 0; i < header.size(); ++i) {
    body_ += fmt::format("<th scope=\"col\"{}>{}</th>", classOf(i), escaped(header[i].name));
  }
  body_ += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    assert(row.size() == header.size());
    body_ += "<tr>";
    for (std::size_t i = 0; i < header.size(); ++i) {
      const char* tag = header[i].heads_row ? "th scope=\"row\"" : "td";
      const char* end = header[i].heads_row ? "th" : "td";
      body_ += fmt::format("<{}{}>{}</{}>", tag, classOf(i), row[i].markup(), end);
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void Page::figure(std::string_view svg, std::string_view caption) {
  body_ += "<figure>\n";
  body_ += svg;
  if (!caption.empty()) body_ += "<figcaption>" + escaped(caption) + "</figcaption>";
  body_ += "</figure>\n";
}

void Page::preformatted(std::string_view text) { body_ += "<pre>" + escaped(text) + "</pre>\n"; }

void Page::beginDetails(std::string_view summary, bool open) {
  body_ += fmt::format("<details{}><summary>{}</summary>\n", open ? " open=\"open\"" : "", escaped(summary));
  ++open_details_;
}

void Page::endDetails() {
  assert(open_details_ > 0);
  body_ += "</details>\n";
  --open_details_;
}

std::string Page::html() const {
  assert(open_details_ == 0);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"generator\" content=\"Fidelis {}\"/>\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
      core::kVersion, escaped(title_), kStyle);
  page += "<header><h1>" + escaped(title_) + "</h1>";
  if (!subtitle_.empty()) page += "<p class=\"subtitle\">" + escaped(subtitle_) + "</p>";
  page += "</header>\n" + banners_ + answer_;
  if (contents_.size() >= 3) {
    page += "<nav aria-label=\"Contents\"><ul>\n";
    for (const Entry& entry : contents_) {
      page += "<li>" + link("#" + entry.anchor, entry.title).markup() + "</li>\n";
    }
    page += "</ul></nav>\n";
  }
  page += "<main>\n" + body_ + "</main>\n";
  page +=
      fmt::format("<footer>Made by Fidelis {}. This file needs nothing else to be read.</footer>\n</body>\n</html>\n",
                  core::kVersion);
  return page;
}

}  // namespace report
