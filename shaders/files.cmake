# Every shader file that is compiled in, by its name in the shader library. One a line.
set(RUSHLIGHT_SHADER_FILES
  interop/bindings.h
)
