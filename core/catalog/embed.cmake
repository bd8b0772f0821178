# cmake -D ROOT=... -D LIST=file-with-paths -D OUT=x.cpp -P embed.cmake: writes a .cpp that holds the texts of those files.
# Of sources only those that yield steps are taken.
file(STRINGS ${LIST} paths)
list(SORT paths)
set(body "")
set(table "")
set(n 0)
foreach(path ${paths})
  file(READ ${ROOT}/${path} text)
  string(FIND "${text}" "co_yield" yields)
  if(path MATCHES "\\.cpp$" AND yields EQUAL -1)
    continue()
  endif()
  string(APPEND body "constexpr std::string_view text${n} = R\"mwtext(${text})mwtext\";\n")
  string(APPEND table "        {\"${path}\", text${n}},\n")
  math(EXPR n "${n} + 1")
endforeach()
file(WRITE ${OUT}
  "// Made by core/catalog/embed.cmake.\n#include \"core/catalog/resources.h\"\n\nnamespace mw {\nnamespace {\n${body}}  // namespace\n\nconst std::vector<Resource>& resources()\n{\n    static const std::vector<Resource> all = {\n${table}    };\n    return all;\n}\n\n}  // namespace mw\n")
