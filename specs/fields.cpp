#include "specs/fields.h"

#include <charconv>

#include "core/text.h"

namespace specs {

namespace {

// A field that is a text already.
template <class T, auto member>
std::string getText(const T& item) {
  return item.*member;
}
template <class T, auto member>
std::string setText(T& item, const std::string& text) {
  item.*member = text;
  return "";
}
template <class T, auto member>
constexpr Field<T> textField(std::string_view name, std::string_view title) {
  return {name, title, getText<T, member>, setText<T, member>};
}

template <class T, auto member>
constexpr Field<T> listField(std::string_view name, std::string_view title) {
  return {name, title, [](const T& item) { return joinList(item.*member); },
          [](T& item, const std::string& text) {
            item.*member = splitList(text);
            return std::string();
          }};
}

/// An enum that is written by its name.
template <class T, auto member, auto parse>
constexpr Field<T> namedField(std::string_view title_lower, std::string_view title) {
  return {title_lower, title, [](const T& item) { return std::string(specs::name(item.*member)); },
          [](T& item, const std::string& text) {
            const auto value = parse(core::lowerCase(core::trimmed(text)));
            if (!value) return "'" + text + "' is not known";
            item.*member = *value;
            return std::string();
          }};
}

std::optional<Status> parseStatus(const std::string& text) { return statusOf(text); }
std::optional<Level> parseLevel(const std::string& text) { return levelOf(text); }

template <class T>
constexpr Field<T> kUid = textField<T, &T::uid>("uid", "Internal id");
template <class T>
constexpr Field<T> kId = textField<T, &T::id>("id", "Id");
template <class T>
constexpr Field<T> kTitle = textField<T, &T::title>("title", "Title");
template <class T>
constexpr Field<T> kText = textField<T, &T::text>("text", "Text");
template <class T>
constexpr Field<T> kRationale = textField<T, &T::rationale>("rationale", "Rationale");
template <class T>
constexpr Field<T> kAuthor = textField<T, &T::author>("author", "Author");
template <class T>
constexpr Field<T> kStatus = namedField<T, &T::status, parseStatus>("status", "Status");

std::string getFrames(const AcceptanceTest& test) { return test.frames ? std::to_string(*test.frames) : ""; }

std::string setFrames(AcceptanceTest& test, const std::string& text) {
  const std::string digits = core::trimmed(text);
  test.frames.reset();
  if (digits.empty()) return "";
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value < 1) {
    return "'" + text + "' is no number of frames (a whole number from 1 on, or nothing)";
  }
  test.frames = value;
  return "";
}

std::string getOptions(const AcceptanceTest& test) {
  std::vector<std::string> pairs;
  for (const auto& [key, value] : test.options) pairs.push_back(key + "=" + value);
  return joinList(pairs);
}

std::string setOptions(AcceptanceTest& test, const std::string& text) {
  test.options.clear();
  for (const std::string& pair : splitList(text)) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) return "option '" + pair + "' has no '='";
    test.options[core::trimmed(pair.substr(0, equals))] = pair.substr(equals + 1);
  }
  return "";
}

template <class T>
constexpr Field<T> kExperiment = textField<T, &T::experiment>("experiment", "Experiment");
template <class T>
constexpr Field<T> kDevice = textField<T, &T::device>("device", "Measurement device");

constexpr Field<Requirement> kRequirement[] = {
    kUid<Requirement>,
    kId<Requirement>,
    kTitle<Requirement>,
    kText<Requirement>,
    kRationale<Requirement>,
    kAuthor<Requirement>,
    kStatus<Requirement>,
    namedField<Requirement, &Requirement::level, parseLevel>("level", "Level"),
    listField<Requirement, &Requirement::effects>("effects", "Effects bound"),
};

constexpr Field<AcceptanceTest> kAcceptanceTest[] = {
    kUid<AcceptanceTest>,
    kId<AcceptanceTest>,
    kTitle<AcceptanceTest>,
    kText<AcceptanceTest>,
    kRationale<AcceptanceTest>,
    kAuthor<AcceptanceTest>,
    kStatus<AcceptanceTest>,
    kExperiment<AcceptanceTest>,
    textField<AcceptanceTest, &AcceptanceTest::model>("model", "Model"),
    textField<AcceptanceTest, &AcceptanceTest::measurand>("measurand", "Measurand"),
    textField<AcceptanceTest, &AcceptanceTest::gate>("gate", "Gate"),
    textField<AcceptanceTest, &AcceptanceTest::metric>("metric", "Metric"),
    textField<AcceptanceTest, &AcceptanceTest::expression>("expression", "Accepted if"),
    listField<AcceptanceTest, &AcceptanceTest::samples>("samples", "Samples"),
    {"frames", "Frames", getFrames, setFrames},
    {"options", "Options", getOptions, setOptions},
};

constexpr Field<ExperimentData> kExperimentData[] = {
    kUid<ExperimentData>,
    kId<ExperimentData>,
    kTitle<ExperimentData>,
    kText<ExperimentData>,
    kRationale<ExperimentData>,
    kAuthor<ExperimentData>,
    kStatus<ExperimentData>,
    kExperiment<ExperimentData>,
    kDevice<ExperimentData>,
    textField<ExperimentData, &ExperimentData::conditions>("conditions", "Conditions"),
    textField<ExperimentData, &ExperimentData::repetitions>("repetitions", "Repetitions"),
};

constexpr Field<ReferenceData> kReferenceData[] = {
    kUid<ReferenceData>,       kId<ReferenceData>,
    kTitle<ReferenceData>,     kText<ReferenceData>,
    kRationale<ReferenceData>, kAuthor<ReferenceData>,
    kStatus<ReferenceData>,    textField<ReferenceData, &ReferenceData::quantity>("quantity", "Quantity"),
    kDevice<ReferenceData>,    textField<ReferenceData, &ReferenceData::uncertainty>("uncertainty", "Uncertainty"),
};

}  // namespace

template <>
std::span<const Field<Requirement>> fieldsOf<Requirement>() {
  return kRequirement;
}
template <>
std::span<const Field<AcceptanceTest>> fieldsOf<AcceptanceTest>() {
  return kAcceptanceTest;
}
template <>
std::span<const Field<ExperimentData>> fieldsOf<ExperimentData>() {
  return kExperimentData;
}
template <>
std::span<const Field<ReferenceData>> fieldsOf<ReferenceData>() {
  return kReferenceData;
}

std::string joinList(std::span<const std::string> parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += "; ";
    // A lone empty part must differ from no part at all, and blanks at the ends must survive the trimming.
    const bool keep = parts[i].empty() || core::trimmed(parts[i]) != parts[i];
    if (keep) text += "\\.";
    for (const char c : parts[i]) {
      if (c == ';' || c == '\\') text += '\\';
      text += c;
    }
    if (keep) text += "\\.";
  }
  return text;
}

std::vector<std::string> splitList(std::string_view text) {
  std::vector<std::string> parts;
  if (core::trimmed(text).empty()) return parts;
  std::string part;
  std::size_t kept = 0;  // length up to which blanks at the end are meant
  bool begun = false;
  const auto finish = [&] {
    while (part.size() > kept && (part.back() == ' ' || part.back() == '\n')) part.pop_back();
    parts.push_back(part);
    part.clear();
    kept = 0;
    begun = false;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\' && i + 1 < text.size()) {
      const char next = text[++i];
      begun = true;
      if (next != '.') part += next;  // "\." marks an end that must not be trimmed
      kept = part.size();
    } else if (c == ';') {
      finish();
    } else if (begun || (c != ' ' && c != '\n')) {
      begun = true;
      part += c;
    }
  }
  finish();
  // A separator at the very end was typed by a person and means nothing.
  if (parts.size() > 1 && parts.back().empty() && core::trimmed(text).back() == ';') parts.pop_back();
  return parts;
}

}  // namespace specs
