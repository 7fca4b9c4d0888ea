# Begins at the first statement behind the start; CMakeLists.txt says what is to be seen.
set breakpoint pending on
tbreak survey.pal:48
run
list 48,48
pal-next
pal-next
pal-next
pal-next
pal-next
kill
