/* The version in kyvadlo.h and of the library that is linked are the one given. */
#include <stdio.h>
#include <string.h>
#include <kyvadlo.h>

int main(int count, char **words)
{
  char numbers[40];
  if (count != 2) return 2;
  sprintf(numbers, "%d.%d.%d", KYVADLO_VERSION_MAJOR, KYVADLO_VERSION_MINOR, KYVADLO_VERSION_PATCH);
  printf("%s %s %s\n", KYVADLO_VERSION, kyvadlo_version(), numbers);
  return strcmp(KYVADLO_VERSION, words[1]) != 0 || strcmp(kyvadlo_version(), words[1]) != 0 || strcmp(numbers, words[1]) != 0;
}
