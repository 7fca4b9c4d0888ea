# cmake -DSCHEMA=operation.schema.json -DOUTPUT=embedded_schema.cpp -P embed_schema.cmake: the schema as a text of the program.
file(READ "${SCHEMA}" content)
file(WRITE "${OUTPUT}" "// Generated from operations/schema; change that.
#include \"language_server/operation_schema.hpp\"

namespace pal::language_server {

std::string_view operation_schema_text() {
  return R\"SCHEMA(${content})SCHEMA\";
}

}  // namespace pal::language_server
")
