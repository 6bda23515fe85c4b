# Sets `mathjax` and `doc_stylesheets` to what is found: how formulas are drawn and what pages look like.

# Formulas without a network: a copy of what pages need of MathJax.
set(mathjax "https://cdn.jsdelivr.net/npm/mathjax@2")
find_path(MATHJAX_DIR MathJax.js PATHS /usr/share/javascript/mathjax NO_DEFAULT_PATH
  DOC "Directory of MathJax 2 (Debian: libjs-mathjax)")
mark_as_advanced(MATHJAX_DIR)
if(MATHJAX_DIR)
  set(mathjax mathjax)
  foreach(part IN ITEMS MathJax.js extensions jax/element jax/input/TeX jax/output/HTML-CSS/jax.js
      jax/output/HTML-CSS/config.js jax/output/HTML-CSS/autoload jax/output/HTML-CSS/fonts/TeX
      fonts/HTML-CSS/TeX/otf fonts/HTML-CSS/TeX/woff)
    cmake_path(GET part PARENT_PATH folder)
    file(COPY "${MATHJAX_DIR}/${part}" DESTINATION "${CMAKE_CURRENT_BINARY_DIR}/html/mathjax/${folder}")
  endforeach()
else()
  message(STATUS "MathJax not found (Debian: libjs-mathjax): formulas of the documentation need a network")
endif()

# The look of pages.
find_path(DOXYGEN_AWESOME_DIR doxygen-awesome.css PATHS /usr/share/doxygen-awesome-css NO_DEFAULT_PATH
  DOC "Directory of the theme of the documentation (Debian: doxygen-awesome-css)")
mark_as_advanced(DOXYGEN_AWESOME_DIR)
set(doc_stylesheets "\"${CMAKE_CURRENT_SOURCE_DIR}/style.css\"")
if(DOXYGEN_AWESOME_DIR)
  string(PREPEND doc_stylesheets "\"${DOXYGEN_AWESOME_DIR}/doxygen-awesome.css\" ")
else()
  message(STATUS "doxygen-awesome-css not found: the documentation looks plain")
endif()
