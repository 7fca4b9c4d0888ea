# cmake -DFOLDER=pages -DOUTPUT=embedded.cpp -P embed.cmake: writes every page into one C++ table.
file(GLOB pages "${FOLDER}/PAL*.md")
list(SORT pages)
set(text "// Generated from pal/explain/pages; change those.\n#include \"pal/explain/embedded.hpp\"\n\n")
string(APPEND text "namespace pal::explain {\n\nnamespace {\n\nconstexpr EmbeddedPage rows[] = {\n")
foreach(page IN LISTS pages)
  get_filename_component(code "${page}" NAME_WE)
  file(READ "${page}" content)
  # A page without a row in diagnostic_code.def does not compile.
  string(APPEND text "    {Code::${code}, R\"PAGE(${content})PAGE\"},\n")
endforeach()
string(APPEND text "};\n\n}  // namespace\n\nstd::span<const EmbeddedPage> embedded_pages() {\n  return rows;\n}\n\n}  // namespace pal::explain\n")
file(WRITE "${OUTPUT}" "${text}")
