# The library's version, from gjk/version.h. Source it: sets version; fill FILE prints a template with it filled in.
version=$(awk '/^#define GJK_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $3; dot = "." } END { print v }' include/gjk/version.h)

fill() {
  sed "s/@VERSION@/$version/g; s/@MAJOR@/${version%%.*}/g; s/@MINOR@/$(echo "$version" | cut -d. -f2)/g" "$1"
}
