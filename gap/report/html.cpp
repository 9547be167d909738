#include "gap/report/html.h"

#include "gap/report/sections.h"

namespace gap {

std::string reportHtml(const Diagnosis& diagnosis) {
  report::Page page("Why do measurement and simulation differ?", "Diagnosis of the experiment " + diagnosis.experiment +
                                                                     ", simulated with the model " + diagnosis.model);
  if (diagnosis.synthetic) {
    page.banner("Synthetic data: the measurement was made by a program, no real sensor measured it.",
                report::Tone::Warning);
  }
  if (diagnosis.present && diagnosis.approximation && !diagnosis.approximation->reliable())
    page.banner("Only an indication: the built-in model that stands for the model under test is too unlike it.",
                report::Tone::Warning);
  addAnswer(page, diagnosis);
  addWhere(page, diagnosis);
  addCauses(page, diagnosis);
  addRest(page, diagnosis);
  addHowFar(page, diagnosis);
  addNext(page, diagnosis);
  addMethod(page, diagnosis);
  return page.html();
}

}  // namespace gap
