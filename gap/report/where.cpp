#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

#include "gap/report/sections.h"
#include "gap/report/titles.h"
#include "gap/report/wording.h"
#include "report/panel_figure.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

std::vector<Html> cellsOf(const WhereRow& row) {
  return {report::text(whereClause(row) + "."), report::text(withUnit(row.value, row.unit)),
          report::shareBar(row.share), report::text(percent(row.size)), report::text(certaintyInWords(row.p_value))};
}

const std::vector<report::TableColumn>& columns() {
  static const std::vector<report::TableColumn> kColumns = {{"what differs, and where", Align::Left, true},
                                                            {"measured − simulated", Align::Right},
                                                            {"share of this difference"},
                                                            {"share of the data", Align::Right},
                                                            {"chance?"}};
  return kColumns;
}

/// One line a kind of difference; what the same difference looks like along other quantities is folded away, and what
/// may be chance, unless everything may.
void addRows(report::Page& page, const std::vector<WhereRow>& rows) {
  const PartedRows parted = partedByKind(rows);
  const auto cells = [](const std::vector<WhereRow>& some) {
    std::vector<std::vector<Html>> table;
    for (const WhereRow& row : some) table.push_back(cellsOf(row));
    return table;
  };
  page.table(columns(), cells(parted.first));
  std::vector<std::vector<Html>> others = cells(parted.others);
  if (others.empty()) return;
  page.beginDetails(
      "The same differences along other quantities (distance, direction, object, set-up …), and what may be chance");
  page.paragraph("Several of these lines often describe the same thing: far targets also return narrow echoes.");
  if (others.size() > 24) others.resize(24);
  page.table(columns(), others);
  page.endDetails();
}

/// Emission › **Propagation** › …
void addBlock(report::Page& page, const Diagnosis& diagnosis) {
  std::set<std::string> blocks;
  for (const Cause& cause : diagnosis.causes) {
    if (diagnosis.verdict.isNamed(cause.name) && !cause.decomposition_block.empty())
      blocks.insert(cause.decomposition_block);
  }
  if (blocks.empty()) return;
  using model::Stage;
  constexpr std::array<Stage, 6> kStages = {Stage::kEmission,  Stage::kPropagation,   Stage::kInteraction,
                                            Stage::kReception, Stage::kPreProcessing, Stage::kDetection};
  Html chain = report::text("In the chain from emission to detection the cause sits here: ");
  std::string before;
  for (const Stage stage : kStages) {
    const std::string name = model::toString(stage);
    if (name == before) continue;  // two stages may belong to one block of the functional decomposition
    if (!before.empty()) chain += report::text(" → ");
    before = name;
    chain += blocks.count(name) ? report::badge(name, report::Tone::Bad) : report::text(name);
  }
  page.paragraph(chain + report::text("."));
}

void addMaps(report::Page& page, const Diagnosis& diagnosis, const std::string& measurand) {
  const bool existence = measurand == "existence";
  report::PanelFigure figure;
  figure.x_name = "azimuth in °";
  figure.y_name = "elevation";
  figure.x_grows_leftwards = true;
  figure.low_end = existence ? "echoes missing" : "measured smaller";
  figure.high_end = existence ? "extra echoes" : "measured larger";
  for (const ResidualMap& map : diagnosis.maps) {
    if (map.measurand != measurand) continue;
    figure.value_name = fmt::format("measured − simulated in {}", existence ? "echoes per shot" : map.unit);
    report::PanelFigure::Panel panel;
    const std::string what = map.component == "bias" ? "mean" : map.component;
    panel.title = fmt::format("{}{}, sample {}", what, existence ? " echoes" : "", map.sample);
    panel.row_names = map.rows;
    panel.cell_width = map.azimuth_step_deg;
    for (const ResidualMap::Point& p : map.points)
      panel.cells.push_back({p.azimuth_deg, static_cast<double>(p.row), p.value});
    figure.panels.push_back(std::move(panel));
  }
  figure.title = fmt::format("{}{}: measured minus simulated, as the sensor sees the scene",
                             static_cast<char>(std::toupper(static_cast<unsigned char>(measurandTitle(measurand)[0]))),
                             measurandTitle(measurand).substr(1));
  page.figure(report::panelFigure(figure),
              fmt::format("Each field is one direction of the beam, seen from the sensor. White: both agree; blue: {}; "
                          "red: {}; grey: neither "
                          "side has data. All panels share one colour scale. Shown are the samples that differ most.",
                          existence ? "the measurement lacks echoes that the simulation has" : "measured is smaller",
                          existence ? "the measurement has echoes that the simulation lacks" : "measured is larger"));
}

}  // namespace

void addWhere(report::Page& page, const Diagnosis& diagnosis) {
  page.section("Where do they differ?", "where");
  if (!diagnosis.present || diagnosis.where.empty()) {
    page.lead("All distances, directions, objects and settings were searched for a part of the data that deviates.");
    page.paragraph(diagnosis.present
                       ? "No part of the data deviates by itself: what the answer says shows only when all data are "
                         "taken together."
                       : "No part of the data deviates by more than its uncertainty and by enough to matter.");
    if (diagnosis.maps.empty()) return;
    page.beginDetails("Maps of the differences that are left");
  } else {
    page.lead(
        "Each line names one kind of difference and the part of the data that concentrates it; the bar says how "
        "much of that difference lies there, the next column how much of the data." +
        std::string(diagnosis.after ? " What the cause below changes most comes first." : ""));
    addRows(page, diagnosis.where);
    addBlock(page, diagnosis);
  }
  std::vector<std::string> shown;
  for (const ResidualMap& map : diagnosis.maps) {
    if (std::find(shown.begin(), shown.end(), map.measurand) != shown.end()) continue;
    shown.push_back(map.measurand);
    addMaps(page, diagnosis, map.measurand);
  }
  if (!diagnosis.present || diagnosis.where.empty()) page.endDetails();
}

}  // namespace gap
