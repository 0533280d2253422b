// A document that only records which keys its reader asks for (keys.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/settings_document.h"
#include "core/text/text.h"

namespace soilweave {
namespace {

std::optional<std::string> unless_empty(std::string text) {
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

}  // namespace

Settings Settings::describing(KeyRecorder& recorder) {
  auto document = std::make_shared<Document>();
  document->recorder = &recorder;
  void* root = &document->root;
  return {std::move(document), "", root};
}

double Settings::noted(const Parameter& p, Key::Type type, std::optional<double> fallback,
                       std::vector<std::string> words, std::string standard) {
  if (fallback) standard = number_text(*fallback);
  document_->recorder->note({path_, std::string(p.name), type, std::string(p.unit), std::string(p.sentence),
                             std::string(p.why), p.low, p.high, p.open, std::move(words),
                             unless_empty(std::move(standard))});
  return fallback.value_or(document_->recorder->value(p));
}

void Settings::note_word(const Word& word, Key::Type type, std::vector<std::string> words, std::string standard) {
  document_->recorder->note({path_, std::string(word.name), type, "", std::string(word.sentence), "", 0, 0, false,
                             std::move(words), unless_empty(std::move(standard))});
}

std::string Settings::noted_choice(const Word& word, const std::vector<std::string>& values,
                                   const std::optional<std::string>& fallback, bool governs) {
  note_word(word, Key::Type::choice, values, fallback ? fmt::format("\"{}\"", *fallback) : "");
  return document_->recorder->choose(path_, word.name, values, governs);
}

std::string list_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + number_text(x);
  return "[" + text + "]";
}

}  // namespace soilweave
