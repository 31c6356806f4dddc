#include "canvoy/text/pdo_words.hpp"

#include "canvoy/text/object_words.hpp"
#include "canvoy/text/service_words.hpp"

namespace canvoy::text {

PdoWords::Words PdoWords::words(std::uint32_t can_id, const decoder::Decoded& decoded,
                                std::uint32_t generation) {
  Pdo& pdo = pdos_.at(can_id);
  const bool is_new = pdo.generation != generation;
  if (decoded.is_same && !is_new) return {pdo.service, pdo.text, &pdo.kept};
  if (is_new) {
    name(pdo, *decoded.pdo);
    pdo.generation = generation;
  }
  const bool has_changed = take_values(pdo, decoded.values);
  if (!is_new && !has_changed && pdo.count == decoded.values.size()) {
    return {pdo.service, pdo.text, &pdo.kept};
  }
  pdo.count = decoded.values.size();
  pdo.text = pdo.start;
  pdo.kept.clear();
  for (std::size_t i = 0; i < pdo.count; ++i) {
    if (i != 0) pdo.text += "; ";
    pdo.text += pdo.values[i].name;
    pdo.text += pdo.values[i].text;
  }
  return {pdo.service, pdo.text, &pdo.kept};
}

void PdoWords::name(Pdo& pdo, const decoder::PdoPlan& plan) {
  pdo.service = pdo_service(plan);
  pdo.start = plan.name.empty() ? "" : std::string(plan.name) + ": ";
  pdo.values.clear();
}

/// True if one of them has changed.
bool PdoWords::take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values) {
  bool has_changed = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == pdo.values.size()) pdo.values.push_back({0, object_name_text(values[i]) + " = ", {}});
    Value& known = pdo.values[i];
    // A multiplexed PDO has another object each time.
    const bool is_other = values[i].version == 0;
    if (is_other) known.name = object_name_text(values[i]) + " = ";
    if (known.version == values[i].version && !is_other) continue;
    known.version = values[i].version;
    known.text.clear();
    values_->append(known.text, values[i]);
    has_changed = true;
  }
  return has_changed;
}

}  // namespace canvoy::text
