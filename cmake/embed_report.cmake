# cmake -P embed_report.cmake OUT.cpp PAGE.html STYLE.css SCRIPT.js…
# Writes the page's files as string literals; the scripts one after the other, in their order.
set(html "")
set(style "")
set(script "")
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE 4 ${last})
    file(READ "${CMAKE_ARGV${i}}" text)
    if(i EQUAL 4)
        set(part html)
    elseif(i EQUAL 5)
        set(part style)
    else()
        set(part script)
    endif()
    string(APPEND ${part} "${text}")
endforeach()
set(code "// Written by cmake/embed_report.cmake.
#include \"compare/report_page_parts.hpp\"

namespace prelight::app {
")
foreach(part html style script)
    string(APPEND code "const std::string_view report_${part} = R\"PRELIGHT(${${part}})PRELIGHT\";\n")
endforeach()
string(APPEND code "} // namespace prelight::app\n")
file(WRITE "${CMAKE_ARGV3}" "${code}")
