// The specification as one page: no script, no file beside it.

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "specs/documents.h"
#include "specs/fields.h"
#include "specs/rules.h"
#include "specs/trace.h"

namespace specs {

namespace {

constexpr const char* kStyle = R"css(
:root { --ink: #1d252c; --soft: #5b6770; --line: #d5dce2; --tint: #f5f7f9; --link: #0b5394; }
* { box-sizing: border-box; }
body { font: 16px/1.5 "Source Sans 3", "Segoe UI", "DejaVu Sans", Helvetica, Arial, sans-serif; color: var(--ink);
  max-width: 66rem; margin: 0 auto; padding: 2.5rem 1.5rem 5rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.35rem; margin: 3rem 0 1rem; padding-bottom: .3rem; border-bottom: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 0 0 .4rem; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
nav a { margin-right: 1.2rem; white-space: nowrap; }
.lead, .none { color: var(--soft); }
.id { font-family: "DejaVu Sans Mono", Consolas, monospace; font-size: .82em; overflow-wrap: anywhere; }
.item { border: 1px solid var(--line); border-left: 4px solid var(--line); border-radius: 4px; padding: .9rem 1.1rem;
  margin: 0 0 1rem; break-inside: avoid; }
.item:target { background: #fffbe8; }
.item.accepted { border-left-color: #2e8b57; } .item.rejected { border-left-color: #b3261e; }
.item.under-review { border-left-color: #c98a00; }
.item p { margin: .3rem 0; white-space: pre-line; }
.badge { display: inline-block; font-size: .78rem; font-weight: 600; padding: 0 .55em; border-radius: 1em;
  border: 1px solid currentColor; margin-left: .35em; white-space: nowrap; vertical-align: .08em; }
.badge.s-accepted, .badge.s-passed { color: #1c6b40; background: #e7f5ec; }
.badge.s-rejected, .badge.s-failed, .badge.s-error { color: #9c1c15; background: #fbeae9; }
.badge.s-under-review, .badge.s-warning { color: #7a5200; background: #fff5dc; }
.badge.s-skipped, .badge.s-level, .badge.s-note { color: #4a555d; background: #eef1f4; }
dl { display: grid; grid-template-columns: 11rem 1fr; gap: .15rem 1rem; margin: .5rem 0 0; font-size: .93rem; }
dt { color: var(--soft); } dd { margin: 0; white-space: pre-line; overflow-wrap: anywhere; }
code { font-family: "DejaVu Sans Mono", Consolas, monospace; font-size: .88em; background: var(--tint); padding: .1em .3em; }
.trace { margin-top: .6rem; padding-top: .5rem; border-top: 1px dashed var(--line); font-size: .9rem; }
.trace div { display: grid; grid-template-columns: 7.5rem 1fr; }
.trace b { font-weight: 400; color: var(--soft); } .trace .end { display: block; }
table { border-collapse: collapse; width: 100%; font-size: .88rem; } thead { display: table-header-group; }
th, td { text-align: left; vertical-align: top; padding: .4rem .6rem; border-bottom: 1px solid var(--line); }
th { background: var(--tint); } td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
tr { break-inside: avoid; } tr:target { background: #fffbe8; }
@media print { body { max-width: none; padding: 0; font-size: 10pt; } nav { display: none; } a { color: inherit; }
  h2 { break-after: avoid; } @page { margin: 18mm; } }
)css";

std::string escaped(std::string_view text) { return core::escapeMarkup(text); }

/// Status and verdict never by colour alone: a sign and the word carry them too.
std::string badge(std::string_view word) {
  std::string style(word);
  std::replace(style.begin(), style.end(), ' ', '-');
  const char* sign = word == "accepted" || word == "passed"   ? "✓ "
                     : word == "rejected" || word == "failed" ? "✗ "
                     : word == "error"                        ? "! "
                     : word == "warning"                      ? "⚠ "
                                                              : "○ ";
  return "<span class=\"badge s-" + style + "\">" + sign + std::string(word) + "</span>";
}

std::string anchor(const LinkIndex& index, const std::string& id) {
  const Entry* entry = index.find(id);
  if (!entry) return "<span class=\"id\">" + escaped(id) + "</span> (missing)";
  return "<a href=\"#" + escaped(id) + "\" title=\"" + escaped(name(entry->kind)) + ": " + escaped(entry->title) +
         "\"><span class=\"id\">" + escaped(id) + "</span></a>";
}

std::string traceLine(const LinkIndex& index, const char* heading, const std::vector<Link>& links,
                      std::string Link::*end) {
  std::string line = std::string("<div><b>") + heading + "</b>";
  if (links.empty()) line += "<span class=\"none\">nothing</span>";
  line += "<span>";
  for (const Link& link : links) {
    const Entry* entry = index.find(link.*end);
    line += "<span class=\"end\">" + anchor(index, link.*end) + (link.suspect ? badge("suspect") : "") +
            (entry ? " " + escaped(entry->title) : "") + "</span>";
  }
  return line + "</span></div>\n";
}

std::string traces(const LinkIndex& index, const std::string& id) {
  return "<div class=\"trace\">\n" + traceLine(index, "Follows from", index.originsOf(id), &Link::from) +
         traceLine(index, "Leads to", index.followersOf(id), &Link::to) + "</div>\n";
}

std::string styleOf(Status status) {
  return status == Status::UnderReview ? "under-review" : std::string(name(status));
}

template <class T>
std::string itemCard(const T& item, const Specification& specification, const LinkIndex& index) {
  std::string html = "<article class=\"item " + styleOf(item.status) + "\" id=\"" + escaped(item.id) + "\">\n<h3>" +
                     escaped(item.title.empty() ? item.id : item.title) + " " + badge(name(item.status));
  if (const auto verdict = specification.verdicts.find(item.id); verdict != specification.verdicts.end()) {
    html += badge(name(verdict->second.verdict));
  }
  html += "</h3>\n<a class=\"id\" href=\"#" + escaped(item.id) + "\">" + escaped(item.id) + "</a>\n";
  if (!item.text.empty()) html += "<p>" + escaped(item.text) + "</p>\n";
  html += "<dl>\n";
  const auto line = [&](std::string_view title, const std::string& value) {
    html += "<dt>" + escaped(title) + "</dt><dd>" + value + "</dd>\n";
  };
  for (const Field<T>& field : fieldsOf<T>()) {
    const bool shown_above = field.name == "uid" || field.name == "id" || field.name == "title" ||
                             field.name == "text" || field.name == "status" || field.name == "level";
    const std::string value = escaped(field.get(item));
    if (!shown_above && !value.empty()) {
      line(field.title, field.name == "expression" ? "<code>" + value + "</code>" : value);
    }
  }
  if (const auto verdict = specification.verdicts.find(item.id);
      verdict != specification.verdicts.end() && !verdict->second.text.empty()) {
    line("Last result", escaped(verdict->second.text));
  }
  return html + "</dl>\n" + traces(index, item.id) + "</article>\n";
}

template <class T>
std::string itemSection(const char* anchor_name, const char* heading, const std::vector<T>& items,
                        const Specification& specification, const LinkIndex& index) {
  std::string html = std::string("<h2 id=\"") + anchor_name + "\">" + heading + "</h2>\n";
  if (items.empty()) html += "<p class=\"none\">None.</p>\n";
  for (const T& item : items) html += itemCard(item, specification, index);
  return html;
}

std::string requirementSections(const Specification& specification, const LinkIndex& index) {
  std::string html;
  for (const auto& [level, anchor_name, heading] :
       {std::tuple{Level::General, "general", "General requirements"},
        std::tuple{Level::ObjectModel, "object-model", "Requirements on the object model"},
        std::tuple{Level::DetectionModel, "detection-model", "Requirements on the detection model"}}) {
    std::vector<Requirement> of_level;
    std::copy_if(specification.requirements.begin(), specification.requirements.end(), std::back_inserter(of_level),
                 [wanted = level](const Requirement& requirement) { return requirement.level == wanted; });
    html += itemSection(anchor_name, heading, of_level, specification, index);
  }
  return html;
}

template <class T>
std::string overviewLine(const char* kind, const std::vector<T>& items) {
  const auto count = [&](Status status) {
    return std::to_string(
        std::count_if(items.begin(), items.end(), [&](const T& item) { return item.status == status; }));
  };
  return std::string("<tr><td>") + kind + "</td><td class=\"n\">" + std::to_string(items.size()) +
         "</td><td class=\"n\">" + count(Status::Accepted) + "</td><td class=\"n\">" + count(Status::UnderReview) +
         "</td><td class=\"n\">" + count(Status::Rejected) + "</td></tr>\n";
}

std::string overview(const Specification& specification) {
  std::string html =
      "<h2 id=\"overview\">Overview</h2>\n<table><thead><tr><th>List</th><th class=\"n\">Items</th>"
      "<th class=\"n\">✓ accepted</th><th class=\"n\">○ under review</th><th class=\"n\">✗ rejected</th></tr></thead>"
      "<tbody>\n" +
      overviewLine("Requirements", specification.requirements) + overviewLine("Acceptance tests", specification.tests) +
      overviewLine("Experiment data requirements", specification.experiment_data) +
      overviewLine("Reference data requirements", specification.reference_data) + "</tbody></table>\n<p>Last results: ";
  for (const Verdict verdict : {Verdict::Passed, Verdict::Failed, Verdict::Error, Verdict::Skipped}) {
    const auto count = std::count_if(specification.verdicts.begin(), specification.verdicts.end(),
                                     [&](const auto& one) { return one.second.verdict == verdict; });
    if (count > 0) html += std::to_string(count) + badge(name(verdict)) + " ";
  }
  if (specification.verdicts.empty()) html += "<span class=\"none\">no test has run yet</span>";
  return html + "</p>\n";
}

std::string scoreCell(const cepra::Score& score) {
  if (score.isEmpty()) return "<span class=\"none\">–</span>";
  return "<b>" + (score.value ? std::to_string(*score.value) : std::string("–")) + "</b> " + escaped(score.rationale) +
         (score.expert.empty() ? "" : " <span class=\"none\">(" + escaped(score.expert) + ")</span>");
}

std::string relevanceRow(const cepra::Row& row, const LinkIndex& index) {
  std::string path;
  for (const cepra::Effect& effect : row.effects) path += (path.empty() ? "" : " ← ") + escaped(effect.title);
  std::string causes;
  for (const cepra::Cause& cause : row.causes) {
    const bool design = cause.kind == percollect::NodeKind::DesignParameter;
    causes += (causes.empty() ? "" : "; ") + escaped(cause.title) + (design ? " (design)" : "");
  }
  std::string followers;
  for (const Link& link : index.followersOf(row.key)) followers += anchor(index, link.to) + " ";
  return "<tr id=\"" + escaped(row.key) + "\"><td><span class=\"id\">" + escaped(row.key) + "</span>" +
         (row.gone ? badge("gone") : "") + (row.isSuspect() ? badge("suspect") : "") + "</td><td>" + path +
         "</td><td>" + causes + "</td><td>" + scoreCell(row.occurrence) + "</td><td>" + scoreCell(row.impact) +
         "</td><td class=\"n\">" + (row.relevance() ? std::to_string(*row.relevance()) : "") + "</td><td>" + followers +
         "</td></tr>\n";
}

/// Only rows that somebody worked on: large graphs have thousands.
std::string relevance(const Specification& specification, const LinkIndex& index) {
  std::string rows;
  std::size_t silent = 0;
  for (const cepra::Row& row : specification.cepra.rows) {
    if (row.hasInput() || row.isSuspect() || !index.followersOf(row.key).empty()) {
      rows += relevanceRow(row, index);
    } else {
      ++silent;
    }
  }
  std::string html = "<h2 id=\"relevance\">Relevance (CEPRA)</h2>\n";
  if (!rows.empty()) {
    html +=
        "<table><thead><tr><th>Row</th><th>Effects, from the phenomenon</th><th>Causes</th><th>Occurrence</th>"
        "<th>Impact</th><th class=\"n\">O+I</th><th>Requirements</th></tr></thead><tbody>\n" +
        rows + "</tbody></table>\n";
  }
  return html + "<p class=\"none\">Further rows, neither scored nor linked: " + std::to_string(silent) + ".</p>\n";
}

std::string findings(const Specification& specification) {
  std::string html = "<h2 id=\"findings\">Open points</h2>\n";
  const auto found = checkSpecification(specification);
  if (found.empty()) return html + "<p>All rules hold.</p>\n";
  html += "<table><thead><tr><th>Item</th><th>Level</th><th>What</th></tr></thead><tbody>\n";
  const LinkIndex index(specification);
  for (const RuleFinding& finding : found) {
    const std::string item = index.find(finding.item) ? anchor(index, finding.item)
                                                      : "<span class=\"id\">" + escaped(finding.item) + "</span>";
    html += "<tr><td>" + item + "</td><td>" + badge(percollect::toString(finding.severity)) + "</td><td>" +
            escaped(finding.text) + " " + escaped(finding.remedy) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

}  // namespace

std::string htmlText(const Specification& specification) {
  const LinkIndex index(specification);
  const std::string title = "Specification: " + escaped(specification.project);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
  if (specification.graph) {
    html += "<p class=\"lead\">Cause-effect graph “" + escaped(specification.graph->tree) + "”, imported " +
            escaped(specification.graph->when) + ", SHA-256 <span class=\"id\">" +
            escaped(specification.graph->sha256.substr(0, 16)) + "…</span></p>\n";
  }
  html +=
      "<nav><a href=\"#overview\">Overview</a><a href=\"#general\">General</a><a href=\"#object-model\">Object model"
      "</a><a href=\"#detection-model\">Detection model</a><a href=\"#tests\">Tests</a><a href=\"#experiment-data\">"
      "Experiment data</a><a href=\"#reference-data\">Reference data</a><a href=\"#relevance\">Relevance</a>"
      "<a href=\"#findings\">Open points</a></nav>\n";
  html +=
      overview(specification) + requirementSections(specification, index) +
      itemSection("tests", "Acceptance tests", specification.tests, specification, index) +
      itemSection("experiment-data", "Experiment data requirements", specification.experiment_data, specification,
                  index) +
      itemSection("reference-data", "Reference data requirements", specification.reference_data, specification, index) +
      relevance(specification, index) + findings(specification);
  return html + "</body>\n</html>\n";
}

void writeHtml(const Specification& specification, const std::filesystem::path& file) {
  core::writeFile(file, htmlText(specification));
}

}  // namespace specs
