# cmake -P embed_report.cmake OUT.cpp NAME PAGE.html STYLE.css SCRIPT.js…
# Writes the page's files as string literals of a `Page` named NAME (apps/prelight/page.hpp); the scripts
# one after the other, in their order.
set(html "")
set(style "")
set(script "")
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE 5 ${last})
    file(READ "${CMAKE_ARGV${i}}" text)
    if(i EQUAL 5)
        set(part html)
    elseif(i EQUAL 6)
        set(part style)
    else()
        set(part script)
    endif()
    string(APPEND ${part} "${text}")
endforeach()
set(code "// Written by cmake/embed_report.cmake.
#include \"page.hpp\"

namespace prelight::app {
extern const Page ${CMAKE_ARGV4}{
")
foreach(part html style script)
    string(APPEND code "    R\"PRELIGHT(${${part}})PRELIGHT\",\n")
endforeach()
string(APPEND code "};\n} // namespace prelight::app\n")
file(WRITE "${CMAKE_ARGV3}" "${code}")
