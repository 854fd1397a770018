/* What the codes of kyvadlo.h mean. In C, as a constant text that lives for ever is C's to give. */
#include "kyvadlo.h"

const char *kyvadlo_message(int code)
{
   switch (code) {
   case KYVADLO_OK: return "no error";
   case KYVADLO_DOMAIN: return "the values break a rule of the motion";
   default: return "unknown code";
   }
}
