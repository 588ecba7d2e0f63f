# Prints what scripts/demo tabulates of a report of `multipatch mesh`, separated by spaces: sides,
# triangles, domain generator, clearance, and the seconds of all stages.
#
# Usage: cmake -DREPORT=FILE.json -P report_row.cmake

cmake_minimum_required(VERSION 3.21)

file(READ ${REPORT} report)
string(JSON sides GET "${report}" model sides)
string(JSON triangles GET "${report}" mesh triangles)
string(JSON generator GET "${report}" domain used)
string(JSON clearance GET "${report}" domain clearance)
if(clearance STREQUAL "") # null: a triangle has no two sides that share no corner
  set(clearance -)
endif()
set(row ${sides} ${triangles} ${generator} ${clearance})

string(JSON stages LENGTH "${report}" seconds)
math(EXPR last "${stages} - 1")
foreach(i RANGE ${last})
  string(JSON stage MEMBER "${report}" seconds ${i})
  string(JSON time GET "${report}" seconds ${stage})
  list(APPEND row ${time})
endforeach()

list(JOIN row " " row)
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${row}")
