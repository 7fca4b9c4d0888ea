#include "analyzer/compositional/measures/sum.hpp"

namespace pal::analyzer::compositional {

Sum::Sum(Nanoseconds amount, Term term) : value_(amount) {
  if (amount == 0 || amount >= never) return;
  auto leaf = std::make_shared<Made>();
  leaf->term = std::move(term);
  leaf->amount = amount;
  made_ = std::move(leaf);
}

Sum operator+(const Sum& one, const Sum& other) {
  if (!one.bounded() || !other.bounded()) return Sum::unbounded();
  if (!other.made_) return {one.value_ + other.value_, one.made_};
  if (!one.made_) return {one.value_ + other.value_, other.made_};
  auto both = std::make_shared<Sum::Made>();
  both->one = one.made_;
  both->other = other.made_;
  return {one.value_ + other.value_, std::move(both)};
}

Sum operator-(const Sum& one, const Sum& other) {
  if (!one.bounded() || !other.bounded()) return Sum::unbounded();
  if (!other.made_) return {one.value_ - other.value_, one.made_};
  auto both = std::make_shared<Sum::Made>();
  both->one = one.made_;
  both->other = other.made_;
  both->minus = true;
  return {one.value_ - other.value_, std::move(both)};
}

std::vector<Sum::Addend> Sum::addends() const {
  std::vector<Addend> out;
  collect(made_.get(), false, out);
  return out;
}

void Sum::collect(const Made* made, bool minus, std::vector<Addend>& out) {
  if (made == nullptr) return;
  if (!made->one && !made->other) {
    out.push_back({minus ? -made->amount : made->amount, made->term});
    return;
  }
  collect(made->one.get(), minus, out);
  collect(made->other.get(), minus != made->minus, out);
}

}  // namespace pal::analyzer::compositional
