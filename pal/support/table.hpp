// A vector that is indexed by one kind of id only.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace pal {

/// The first `size` ids of a kind, in order.
template <class I>
class IdRange {
 public:
  class Iterator {
   public:
    using value_type = I;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = I;
    using iterator_category = std::input_iterator_tag;

    constexpr Iterator() = default;
    constexpr explicit Iterator(std::size_t at) : at_(at) {}
    constexpr I operator*() const { return I(at_); }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr Iterator operator++(int) {
      Iterator before = *this;
      ++at_;
      return before;
    }
    friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::size_t at_ = 0;
  };

  constexpr explicit IdRange(std::size_t size) : size_(size) {}
  constexpr Iterator begin() const { return Iterator(0); }
  constexpr Iterator end() const { return Iterator(size_); }
  constexpr std::size_t size() const { return size_; }

 private:
  std::size_t size_;
};

/// One T for each id: `for (const ThreadId t : threads.ids()) use(threads[t]);`. An id must be valid, and
/// less than the size.
template <class I, class T>
class Table {
 public:
  using value_type = T;
  using reference = typename std::vector<T>::reference;
  using const_reference = typename std::vector<T>::const_reference;
  using iterator = typename std::vector<T>::iterator;
  using const_iterator = typename std::vector<T>::const_iterator;

  Table() = default;
  explicit Table(std::size_t size, const T& value = T()) : values_(size, value) {}
  Table(std::initializer_list<T> values) : values_(values) {}
  explicit Table(std::vector<T> values) : values_(std::move(values)) {}

  reference operator[](I id) { return values_[id.index()]; }
  const_reference operator[](I id) const { return values_[id.index()]; }

  I push_back(T value) {
    values_.push_back(std::move(value));
    return I(values_.size() - 1);
  }
  reference back() { return values_.back(); }
  const_reference back() const { return values_.back(); }
  const_reference front() const { return values_.front(); }

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  void clear() { values_.clear(); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void resize(std::size_t size) { values_.resize(size); }
  void resize(std::size_t size, const T& value) { values_.resize(size, value); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }

  iterator begin() { return values_.begin(); }
  iterator end() { return values_.end(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }
  IdRange<I> ids() const { return IdRange<I>(values_.size()); }
  /// Whether `id` names one of the values.
  bool contains(I id) const { return id.valid() && id.index() < values_.size(); }

  friend bool operator==(const Table&, const Table&) = default;

 private:
  std::vector<T> values_;
};

}  // namespace pal
