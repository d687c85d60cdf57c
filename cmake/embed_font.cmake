# Makes a C++ file of a font file: cmake -DOUT=F.cpp -DFONT=file.ttf -P embed_font.cmake
# Defines its bytes, kFontFile and kFontFileSize, in namespace clearway::render. The file stays whole: it holds its licence.
cmake_minimum_required(VERSION 3.25)

file(READ ${FONT} bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(SIZE ${FONT} size)
file(WRITE ${OUT}.tmp "#include <cstddef>\n\nnamespace clearway::render {\n\n"
     "extern const unsigned char kFontFile[];\nconst unsigned char kFontFile[] = {\n${bytes}};\n"
     "extern const std::size_t kFontFileSize;\nconst std::size_t kFontFileSize = ${size};\n\n"
     "}  // namespace clearway::render\n")
file(RENAME ${OUT}.tmp ${OUT})
