# Unpacks the meshes and point sets of CGAL's data set, which Debian ships in libcgal-demo, into the build tree.
#
# Input:  INTRINSIC_TRIANGULATIONS_CGAL_DATA_ARCHIVE (cache), the file data.tar.gz
# Result: INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR, empty where the archive is missing; point sets are beside it

find_file(INTRINSIC_TRIANGULATIONS_CGAL_DATA_ARCHIVE
  NAMES data.tar.gz
  PATHS /usr/share/doc/libcgal-demo /usr/share/doc/libcgal-dev
  NO_DEFAULT_PATH
  DOC "CGAL's data set, data.tar.gz of Debian's libcgal-demo")

set(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "")
if(INTRINSIC_TRIANGULATIONS_CGAL_DATA_ARCHIVE)
  set(cgal_data "${PROJECT_BINARY_DIR}/cgal_data")
  if(NOT EXISTS "${cgal_data}/unpacked_with_points")
    file(ARCHIVE_EXTRACT INPUT "${INTRINSIC_TRIANGULATIONS_CGAL_DATA_ARCHIVE}"
      DESTINATION "${cgal_data}" PATTERNS "data/meshes/*" "data/points_3/*")
    file(TOUCH "${cgal_data}/unpacked_with_points")
  endif()
  set(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "${cgal_data}/data/meshes")
else()
  message(STATUS
    "CGAL's data set not found (Debian: libcgal-demo); tests and benchmarks on it are left out")
endif()
