#pragma once

#include <string>

#include "acceptance/result.h"

namespace acceptance {

/// The run as JUnit XML, as Jenkins, GitLab and GitHub actions read it: a test suite per acceptance test, a test case
/// per sample (a test that was skipped or could not run has the single case "evaluation").
///
///   classname  project.TestId        name  TestId, sample id: the pair, and the name alone, are unique
///   failure    the expression does not hold; error: it could not be decided; skipped: it was not run
///   properties requirement, expression, value, limit, margin, unit
///
/// No times: the same result gives the same bytes. `attachment` ("" for none) is the HTML report, referred to in
/// system-out as GitLab and the Jenkins attachments plugin expect it.
[[nodiscard]] std::string junitXml(const RunResult& run, const std::string& attachment = "");

}  // namespace acceptance
