// The types in a method of a generated interface. Each skill has message types of its own, generated from the
// same PAL. Activities that several skills share are templates over the interface. They find their message
// types with ResultOf and ArgumentOf.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace pal::skills {

template <class Method>
struct Signature;

template <class Value, class Class, class... Parameters>
struct Signature<Value (Class::*)(Parameters...)> {
  using Result = Value;
  template <std::size_t index>
  using Argument = std::remove_cvref_t<std::tuple_element_t<index, std::tuple<Parameters...>>>;
};

/// What an activity writes: ResultOf<&MC1Activities::obey>.
template <auto method>
using ResultOf = typename Signature<decltype(method)>::Result;

/// What an activity reads, by the order of READS.
template <auto method, std::size_t index = 0>
using ArgumentOf = typename Signature<decltype(method)>::template Argument<index>;

}  // namespace pal::skills
